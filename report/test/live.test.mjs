// The page of `drydock live` before a made-up server (liveMock.mjs): what it sends and when, and what it says when things go
// wrong. liveServer.test.mjs has the real one.
import assert from "node:assert/strict";
import { after, before } from "node:test";
import { setTimeout as sleep } from "node:timers/promises";
import { axeSource, checkAxe, long, onPage, quick, startBrowser, stopBrowser, until } from "./harness.mjs";
import { startMock } from "./liveMock.mjs";
import { readShown } from "./liveServer.mjs";

before(startBrowser);
after(stopBrowser);

const slider = "#set-BloomIntensity";
const box = '[data-setting="BloomIntensity"] .number-box';

/** Edits that the page sent so far, of one place in the config. */
const edits = (mock, pointer = "") => mock.log.filter(({ path, body }) => path === "edit" && body.edits && JSON.stringify(body).includes(pointer));

async function withMock(test, { mock: options, ...more } = {}) {
	const mock = await startMock(options);
	try {
		await onPage(mock.url, (page) => test(page, mock), more);
	} finally {
		await mock.breakOff();
	}
}

/** Presses the slider's thumb and moves it; shares are of the slider's width. */
async function dragSlider(page, selector, shares, pause = 0) {
	const { x, y, width, height } = await page.locator(selector).boundingBox();
	await page.mouse.move(x + width * shares[0], y + height / 2);
	await page.mouse.down();
	for (const share of shares.slice(1)) {
		await page.mouse.move(x + width * share, y + height / 2);
		await page.waitForTimeout(pause);
	}
	await page.mouse.up();
}

/** Until the page sent so many edits. */
async function sends(mock, count) {
	for (const end = Date.now() + 30000; edits(mock).length < count; await sleep(20)) {
		assert.ok(Date.now() < end, `the page sent ${edits(mock).length} edits`);
	}
}

/** Until the page sent so many edits and shows the frame of the newest state. */
async function showsFrameOf(page, mock, count = 1) {
	await sends(mock, count);
	for (const end = Date.now() + 30000; (await page.evaluate(() => document.documentElement.dataset.revision)) !== String(mock.getRevision()); await sleep(20)) {
		assert.ok(Date.now() < end, `the page never showed revision ${mock.getRevision()}`);
	}
}

quick("while a hand drags one edit at most is in flight, the newest value wins, and the page measures itself", async () => {
	await withMock(async (page, mock) => {
		await dragSlider(page, slider, Array.from({ length: 41 }, (_, i) => 0.1 + i * 0.015), 10);
		const last = Number(await page.inputValue(slider));
		await until(page, () => Number(document.querySelector("#latency").dataset.count) > 1);
		await page.waitForTimeout(300);
		const sent = edits(mock, "BloomIntensity");
		assert.ok(sent.length >= 3 && sent.length < 40, `${sent.length} edits of 40 moves`);
		sent.slice(1).forEach((edit, i) => assert.ok(mock.log.slice(mock.log.indexOf(sent[i]), mock.log.indexOf(edit)).some(({ path }) => path === "(frame)"), "an edit was sent while a frame was in flight"));
		assert.deepEqual(sent.at(-1).body.edits, [{ set: "/camera/Settings/BloomIntensity", value: last }]);
		assert.equal(new Set(sent.map(({ body }) => body.drag)).size, 1);
		const { ms, median, count } = await page.evaluate(() => ({ ...document.querySelector("#latency").dataset }));
		assert.ok(Number(ms) >= 150 && Number(median) >= 150 && Number(median) < 3000 && Number(count) >= sent.length - 1);
		assert.match(await page.textContent("#status"), /480 × 270 · passes .* 2 of 3 passes ran.*hand to picture .* median of this drag/);
	}, { mock: { delay: 150 } });
});

quick("at one to one the canvas holds the bytes that the server sent", async () => {
	await withMock(async (page, mock) => {
		await dragSlider(page, slider, [0.2, 0.5, 0.6]);
		await showsFrameOf(page, mock);
		await page.waitForTimeout(600);
		await page.focus("#canvas");
		await page.keyboard.press("1");
		await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
		const { bytes, width, height } = mock.pictures.get("now");
		assert.equal(Buffer.compare(Buffer.from(await page.evaluate(readShown, [width, height]), "base64"), bytes), 0);
	});
});

quick("a bad number stays at its control and is not sent; what the server refuses stands there too", async () => {
	await withMock(async (page, mock) => {
		const said = '[data-setting="BloomIntensity"] .refused';
		for (const [typed, expected] of [["abc", /"abc" is not a number/], ["1,5", /Write 1\.5/], ["-3", /Bloom Intensity goes from 0 up; -3 was not sent/]]) {
			await page.fill(box, typed);
			await page.keyboard.press("Enter");
			assert.match(await page.textContent(said), expected);
			assert.equal(await page.getAttribute(box, "aria-invalid"), "true");
		}
		assert.equal(edits(mock).length, 0);
		await page.fill(box, "2.25");
		await page.keyboard.press("Enter");
		await showsFrameOf(page, mock);
		assert.ok(await page.isHidden(said));
		assert.deepEqual(edits(mock).map(({ body }) => body.edits), [[{ set: "/camera/Settings/BloomIntensity", value: 2.25 }]]);
		await page.fill('[data-setting="BloomThreshold"] .number-box', "500");
		await page.keyboard.press("Enter");
		await until(page, () => /DD1010: BloomThreshold is too large/.test(document.querySelector('[data-setting="BloomThreshold"] .refused').textContent));
	}, { allow: /422/ });
});

quick("a fault stands above the picture with code and place, the last good picture stays, the next frame clears it", async () => {
	await withMock(async (page, mock) => {
		const bytes = () => page.evaluate(() => document.querySelector("#canvas").toDataURL());
		await page.waitForTimeout(700);
		const before = await bytes();
		mock.fail([{ severity: "error", code: "DD4012", message: "unexpected token ';'", where: "MainPS", file: "shaders/Toon.usf", line: 12 }]);
		await page.waitForSelector("#faults div");
		assert.equal(await page.textContent("#faults div"), "shaders/Toon.usf:12 at MainPS DD4012 unexpected token ';'");
		const [fault, canvas] = [await page.locator("#faults").boundingBox(), await page.locator("#canvas").boundingBox()];
		assert.ok(fault.y + fault.height <= canvas.y + 1);
		assert.equal(await bytes(), before);
		mock.fail(null);
		await until(page, () => !document.querySelector("#faults div"));
	});
});

quick("undo, redo and reset by keys and buttons; a second tab and a reload see the same", async () => {
	await withMock(async (page, mock) => {
		const other = await page.context().newPage();
		await other.goto(mock.url);
		await other.waitForSelector("html[data-ready]");
		const shows = (tab, value) => until(tab, (value) => document.querySelector('[data-setting="BloomIntensity"] .number-box').value === value, value);
		await page.fill(box, "3");
		await page.keyboard.press("Enter");
		await shows(other, "3");
		await page.focus("#canvas");
		await page.keyboard.press("Control+z");
		await shows(page, "1.5");
		await page.keyboard.press("Control+Shift+Z");
		await shows(page, "3");
		assert.match(await page.title(), /^• mock/);
		await page.reload();
		await page.waitForSelector("html[data-ready]");
		await shows(page, "3");
		await page.click('[data-setting="BloomIntensity"] .setting-head .small');
		await shows(page, "1.5");
		await shows(other, "1.5");
		await page.click("#undo");
		await shows(page, "3");
		await page.click("#reset");
		await shows(other, "1.5");
	});
});

long("a server that goes away is said and waited for; one that has ended says so", async () => {
	await withMock(async (page, mock) => {
		await mock.breakOff();
		await page.waitForSelector("#notice .error, #notice .bad");
		assert.match(await page.textContent("#notice"), /does not answer.*tries again/);
		assert.ok(await page.isVisible("#canvas"));
		await mock.reopen();
		await until(page, () => !document.querySelector("#notice div"));
		for (const [count, value] of [[1, "3"], [2, "4"]]) {
			await page.fill(box, value);
			await page.keyboard.press("Enter");
			await showsFrameOf(page, mock, count);
		}
		await page.evaluate(() => (document.body.dataset.old = "true"));
		await mock.breakOff();
		mock.restart();
		await mock.reopen();
		await page.waitForSelector("html[data-ready] body:not([data-old])");
		assert.equal(await page.inputValue(slider), "4");
		await page.click("#show-end");
		await page.click("#end-now");
		await until(page, () => /has ended/.test(document.querySelector("#notice").textContent));
	}, { allow: /ERR_|Failed to load/ });
});

quick("a page that is opened before the first frame waits for it, and shows its mistake meanwhile", async () => {
	const mock = await startMock({ ready: false });
	mock.fail([{ severity: "error", code: "DD4012", message: "unexpected token", where: "", file: "Toon.usf", line: 12 }]);
	let told;
	await onPage(mock.url, async (page) => assert.ok(await page.isVisible("#canvas")), { before: (page) => {
		told = until(page, () => /Toon\.usf:12 DD4012 unexpected token/.test(document.querySelector(".waiting")?.textContent)).then(() => mock.fail(null));
	} });
	await told;
	await mock.breakOff();
});

quick("save asks a second time before it writes over a file; text can be copied; the session is a file", async () => {
	await withMock(async (page, mock) => {
		const saves = () => mock.log.filter(({ path }) => path === "save").map(({ body }) => body);
		await page.click("#show-save");
		assert.equal(await page.inputValue("#save-path"), "mock_live.json");
		await page.keyboard.press("Enter");
		await until(page, () => /Saved as mock_live\.json/.test(document.querySelector("#notice").textContent));
		await page.click("#show-save");
		await page.click("#save-now");
		await until(page, () => /exists already/.test(document.querySelector("#save").textContent));
		assert.deepEqual(saves().map(({ again }) => again), [false, false]);
		await page.click("#save-again");
		await until(page, () => !document.querySelector("#save").open);
		assert.deepEqual(saves().at(-1), { path: "mock_live.json", again: true });
		await page.click("#show-copy");
		await page.selectOption("#copy-as", "variables");
		await until(page, () => document.querySelector("#copy-text").value === "text variables\n");
		await page.keyboard.press("Escape");
		const [download] = await Promise.all([page.waitForEvent("download"), page.click("#session")]);
		assert.equal(download.suggestedFilename(), "mock.session.jsonl");
	}, { allow: /409/ });
});

quick("settings are found by words, ticked, edited for a volume, and tell why", async () => {
	await withMock(async (page, mock) => {
		await page.keyboard.press("/");
		await page.keyboard.type("bloom intensity");
		assert.match(await page.textContent("#settings-found"), /^\d+ of \d+ settings$/);
		assert.ok(await page.isVisible(slider));
		assert.ok(await page.isHidden("#set-VignetteIntensity"));
		await page.fill("#settings-search", "motion blur amount");
		assert.match(await page.textContent('[data-setting="MotionBlurAmount"]'), /No active pass reads it/);
		await page.fill("#settings-search", "");
		await page.click('[data-setting="BloomIntensity"] .blended');
		assert.match(await page.textContent('[data-setting="BloomIntensity"] .why-value'), /Base.*0\.675 → 1\.5/s);
		await page.check('[data-setting="BloomIntensity"] input[type="checkbox"]');
		await until(page, () => document.querySelector('[data-setting="BloomIntensity"]').dataset.set === "true");
		assert.deepEqual(edits(mock).at(-1).body.edits, [{ set: "/camera/Settings/BloomIntensity", value: 1.5 }]);
		await page.uncheck('[data-setting="BloomIntensity"] input[type="checkbox"]');
		await sends(mock, 2);
		assert.deepEqual(edits(mock).at(-1).body.edits, [{ remove: "/camera/Settings/BloomIntensity" }]);
		await page.click("#tab-volumes");
		await page.locator(".volume-card", { hasText: "Room" }).getByText("Its settings").click();
		await page.fill(box, "4");
		await page.keyboard.press("Enter");
		await sends(mock, 3);
		assert.deepEqual(edits(mock).at(-1).body.edits, [{ set: "/volumes/1/Settings/BloomIntensity", value: 4 }]);
	});
});

quick("the camera moves among the volumes by mouse and by arrow keys, and the weights follow", async () => {
	await withMock(async (page, mock) => {
		await page.click("#tab-volumes");
		const card = page.locator(".volume-card", { hasText: "Room" });
		assert.match(await card.textContent(), /60 cm away.*acts 40 %/);
		const { x, y, width, height } = await page.locator(".camera .body").boundingBox();
		await page.mouse.move(x + width / 2, y + height / 2);
		await page.mouse.down();
		await page.mouse.move(x + width / 2 + 60, y + height / 2 + 40, { steps: 8 }); // off the path
		await page.mouse.up();
		await until(page, () => /camera inside.*acts 100 %/.test([...document.querySelectorAll(".volume-card")][1].textContent));
		const value = edits(mock, "/view/location").at(-1).body.edits[0].value;
		assert.ok(value[0] > 0 && value[2] === 145); // the path's height
		const before = edits(mock).length;
		await page.keyboard.press("Shift+ArrowLeft");
		await sends(mock, before + 1);
		assert.ok(edits(mock, "/view/location").at(-1).body.edits[0].value[0] < value[0]);
		await page.fill("#volume-1-BlendWeight", "0.5");
		await until(page, () => /acts (4\d|50|[1-4](\.\d)?|3\d|2\d) %/.test([...document.querySelectorAll(".volume-card")][1].textContent));
		await page.uncheck("#volume-1-bEnabled");
		await until(page, () => /does not act/.test([...document.querySelectorAll(".volume-card")][1].textContent));
	});
});

quick("a frame of a sequence is chosen; a texture's file is one of those beside the config", async () => {
	await withMock(async (page, mock) => {
		assert.equal(await page.inputValue("#frame"), "2");
		await page.fill("#sequence .number-box", "4"); // which is not there
		await page.keyboard.press("Enter");
		await sends(mock, 1);
		assert.deepEqual(edits(mock).at(-1).body.edits, [{ set: "/scene/frames", value: "3" }]);
		await until(page, () => document.querySelector("#frame").value === "3");
		await page.fill("#settings-search", "dirt mask");
		await page.focus("#set-BloomDirtMask");
		await until(page, () => [...document.querySelectorAll("#pictures option")].map(({ value }) => value).join() === "textures/dirt.png,lut.png");
		await page.fill("#set-BloomDirtMask", "textures/dirt.png");
		await page.keyboard.press("Enter");
		await sends(mock, 2);
		assert.deepEqual(edits(mock).at(-1).body.edits, [{ set: "/camera/Settings/BloomDirtMask", value: "textures/dirt.png" }]);
	});
});

quick("variables that matter stand there, others are found", async () => {
	await withMock(async (page, mock) => {
		await page.click("#tab-variables");
		assert.deepEqual(await page.locator("#variables [data-variable]").evaluateAll((rows) => rows.map((row) => row.dataset.variable)), ["r.BloomQuality", "r.Tonemapper.Quality", "Bloom", "Vignette"]);
		await page.fill("#variables-search", "dof");
		const field = page.locator('[data-variable="r.DOF.Gather.RingCount"] .text-box');
		await field.fill("many");
		await field.press("Enter");
		await until(page, () => /must be a whole number, but is "many"/.test(document.querySelector("#variables").textContent));
		await field.fill("3");
		await field.press("Enter");
		await until(page, () => /default 5, set by config/.test(document.querySelector("#variables").textContent));
		assert.deepEqual(edits(mock).map(({ body }) => body.edits[0]), ["many", 3].map((value) => ({ set: "/cvars/r.DOF.Gather.RingCount", value })));
		await page.fill("#variables-search", "bloom");
		await page.uncheck("#showFlags-Bloom");
		await sends(mock, 3);
		assert.deepEqual(edits(mock).at(-1).body.edits, [{ set: "/showFlags/Bloom", value: false }]);
	}, { allow: /422/ });
});

quick("pins and the start are compared with now; the difference of one state with itself is nothing", async () => {
	await withMock(async (page, mock) => {
		await page.click("#pin");
		await page.waitForSelector(".pin");
		await dragSlider(page, slider, [0.2, 0.7]);
		await showsFrameOf(page, mock);
		await page.click(".pin button");
		await until(page, () => document.querySelector("#picture").dataset.mode === "slider" && document.querySelector("#picture-b").value === "pin-1");
		await page.click("#mode-difference");
		await until(page, () => /[\d,]+ pixels \(/.test(document.querySelector("#facts").textContent));
		await page.selectOption("#picture-a", "pin-1");
		await until(page, () => /the same in every pixel/.test(document.querySelector("#facts").textContent));
		await page.click('.pin [aria-label="Remove pin 1"]');
		await until(page, () => !document.querySelector(".pin"));
	});
});

quick("passes lead into the graph and to their textures; a texel tells how it came about", async () => {
	await withMock(async (page) => {
		await page.click("#tab-passes");
		assert.match(await page.textContent("#passes"), /1 {2}BloomSetup\s*reused/);
		await page.click('#passes .link:has-text("BloomBlur")');
		await page.waitForSelector("#pass-detail");
		await page.click("#pass-detail .writes .link");
		await page.click("#texture-detail .look");
		await until(page, () => document.querySelector("#picture-a").value === "pass-2-BloomBlur");
		await page.selectOption("#picture-a", "now");
		await page.click("#probe-fold summary");
		await page.click("#canvas", { position: { x: 100, y: 80 } });
		await until(page, () => /Probe of texel \d+, \d+.*BloomSetup {2}0\.25/s.test(document.querySelector("#probe-text").textContent));
		await page.click("#canvas", { position: { x: 100, y: 80 } });
		await until(page, () => /Trace of texel/.test(document.querySelector("#probe-text").textContent));
	});
});

long("each state that was tried leaves a dot when the hand rests", async () => {
	await withMock(async (page) => {
		await dragSlider(page, slider, [0.2, 0.7]);
		await page.click("#tab-price");
		await page.waitForSelector("#price .point");
		await page.click("#undo");
		await until(page, () => document.querySelectorAll("#price .point").length === 2);
		assert.match(await page.textContent("#price table"), /flip/);
	});
});

quick("everything is done by keys alone", async () => {
	await withMock(async (page, mock) => {
		await page.keyboard.press("/");
		await page.keyboard.type("bloom intensity");
		const focus = () => page.evaluate(() => document.activeElement.id || document.activeElement.getAttribute("aria-label") || document.activeElement.textContent);
		for (let i = 0; (await focus()) !== "set-BloomIntensity"; ++i) {
			assert.ok(i < 12, "the slider is not reached by Tab");
			await page.keyboard.press("Tab");
		}
		await page.keyboard.press("ArrowRight");
		await until(page, () => Number(document.querySelector("#set-BloomIntensity").value) > 1.5);
		await sends(mock, 1);
		assert.equal(edits(mock, "BloomIntensity").length, 1);
		await page.focus("#tab-settings");
		await page.keyboard.press("ArrowRight");
		assert.equal(await focus(), "tab-volumes");
		assert.ok(await page.isVisible("#volumes"));
		await page.focus("#canvas");
		await page.keyboard.press("d");
		assert.equal(await page.getAttribute("#picture", "data-mode"), "difference");
	});
});

long("nothing runs over the side or moves when a picture comes, and axe finds nothing serious, in light and dark", async () => {
	const mock = await startMock();
	mock.fail([{ severity: "error", code: "DD4012", message: "unexpected token\n  12 | x;", where: "MainPS", file: "Toon.usf", line: 12 }, { severity: "note", code: "DD1136", message: "an overlay stands in", where: "" }]);
	await checkAxe(mock.url, async (page) => {
		await page.evaluate(() => {
			document.querySelector("#graph-fold").open = true;
			document.querySelectorAll('[role="tabpanel"]').forEach((panel) => (panel.hidden = false));
		});
		await page.waitForSelector("#graph .pass");
	});
	await onPage(mock.url, async (page) => {
		const shifts = () => page.evaluate(() => new Promise((done) => {
			new PerformanceObserver((list) => done(list.getEntries().reduce((sum, entry) => sum + entry.value, 0))).observe({ type: "layout-shift", buffered: true });
			setTimeout(() => done(0), 500);
		}));
		await page.waitForTimeout(500);
		assert.ok((await shifts()) < 0.02, `the page moved by ${await shifts()}`);
		await page.evaluate(axeSource);
		const { violations } = await page.evaluate(() => axe.run(document, { resultTypes: ["violations"] }));
		assert.deepEqual(violations.map(({ id, nodes }) => id + ": " + nodes.map((node) => node.target)), []); // nothing slight, either
	});
	await mock.breakOff();
});
