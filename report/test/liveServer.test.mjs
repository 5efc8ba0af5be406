// `drydock live` as a person uses it, in Chromium and Firefox: a slider is dragged, a shader broken and mended, a state saved,
// and the saved config run: its bits are those that the page showed.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before } from "node:test";
import { setTimeout as sleep } from "node:timers/promises";
import { findFirefox, withFirefox } from "./firefox.mjs";
import { axeSource, checkAxe, findSideways, long, onPage, quick, startBrowser, stopBrowser, until } from "./harness.mjs";
import { ask, drydock, mapDifference, readPng, readShown, source, withLive } from "./liveServer.mjs";

const toonBloom = source + "/configs/toon_bloom.json";
const wide = { viewport: { width: 1820, height: 1100 } }; // the picture at one to one fits
let folder;

before(() => {
	folder = mkdtempSync(join(tmpdir(), "drydock_live_"));
	return startBrowser();
});
after(() => {
	rmSync(folder, { recursive: true });
	return stopBrowser();
});

/** Until the page shows the frame of the newest state, and no hand is at work. */
async function settle(page, url) {
	await until(page, () => document.querySelector("#latency").dataset.ms !== undefined);
	await sleep(600);
	for (const end = Date.now() + 30000; ; await sleep(100)) {
		const { revision, frame } = await (await ask(url, "state")).json();
		if (frame?.revision === revision && (await page.evaluate(() => document.documentElement.dataset.revision)) === String(revision)) {
			return;
		}
		assert.ok(Date.now() < end, `the page never showed revision ${revision}`);
	}
}

async function readPage(page) {
	await page.focus("#canvas");
	await page.keyboard.press("1");
	await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
	return { width: 960, height: 540, bytes: new Uint8Array(Buffer.from(await page.evaluate(readShown, [960, 540]), "base64")) };
}

quick("a dragged slider changes the character's glow alone; saved and run, the config gives the bits that the page showed", async () => {
	await withLive(toonBloom, ["--out", folder], (url) => onPage(url, async (page) => {
		await page.waitForTimeout(1000);
		const start = await readPage(page);
		await page.keyboard.press("/");
		await page.keyboard.type("toon intensity");
		const { x, y, width, height } = await page.locator("#set-BloomToonIntensity").boundingBox();
		await page.mouse.move(x + width * 0.013, y + height / 2);
		await page.mouse.down();
		for (let step = 0; step <= 20; ++step) {
			await page.mouse.move(x + width * (0.013 + step * 0.003), y + height / 2);
		}
		await page.mouse.up();
		await settle(page, url);
		const value = Number(await page.inputValue("#set-BloomToonIntensity"));
		assert.ok(value > 0.2 && value < 1);
		assert.match(await page.textContent("#status"), /hand to picture .* median of this drag/);
		const now = await readPage(page);
		const fields = mapDifference(start, now); // the character stands in the fields 3 to 8 of the rows from 2 on
		fields.forEach((row, i) => row.forEach((most, k) => (i < 2 || k < 3 || k > 9) && assert.ok(most <= 4, `row ${i}, field ${k} changed by ${most}`)));
		assert.ok(Math.max(...fields.flat()) > 12);

		await page.click("#show-save");
		await page.fill("#save-path", join(folder, "saved.json"));
		await page.keyboard.press("Enter");
		await until(page, () => /Saved as/.test(document.querySelector("#notice").textContent));
		execFileSync(drydock, ["run", join(folder, "saved.json"), "--out", join(folder, "saved"), "--report", "off"], { stdio: "ignore" });
		const final = readPng(join(folder, "saved/final.png"));
		assert.deepEqual([final.width, final.height, Buffer.compare(final.bytes, now.bytes)], [960, 540, 0]);
	}, wide));
});

long("a shader is edited into an error and back: the mistake stands above the picture, which stays and then follows", async () => {
	execFileSync(drydock, ["overlay", "new", "Patch", "--pass", "Tonemap"], { cwd: folder, stdio: "ignore" });
	const shader = join(folder, "Patch/Engine/Shaders/Private/PostProcessTonemap.usf");
	const good = readFileSync(shader, "utf8");
	const line = good.split("\n").findIndex((text) => text.includes("OutColor = Tonemap(SvPosition.xy);")) + 1;
	assert.ok(line > 0);
	await withLive(join(folder, "Patch/Patch.json"), [], (url) => onPage(url, async (page) => {
		const bytes = () => page.evaluate(() => document.querySelector("#canvas").toDataURL());
		const revision = () => page.evaluate(() => document.documentElement.dataset.revision);
		await page.waitForTimeout(1500);
		const [before, first] = [await bytes(), await revision()];
		writeFileSync(shader, good.replace("Tonemap(SvPosition.xy);", "Tonemap(SvPosition.xy) * ;"));
		await page.waitForSelector("#faults div", { timeout: 60000 });
		const said = await page.textContent("#faults");
		assert.match(said, /DD\d{4}/);
		assert.ok(said.includes(`PostProcessTonemap.usf:${line}`), said);
		assert.equal(await bytes(), before);
		writeFileSync(shader, good.replace("Tonemap(SvPosition.xy);", "Tonemap(SvPosition.xy).bgra;"));
		await until(page, () => !document.querySelector("#faults div"));
		await until(page, (first) => document.documentElement.dataset.revision !== first, first);
		await page.waitForTimeout(500);
		assert.notEqual(await bytes(), before);
	}));
});

long("by keys alone: a setting is found, moved, taken back and its story read", async () => {
	await withLive(toonBloom, [], (url) => onPage(url, async (page) => {
		const focus = () => page.evaluate(() => document.activeElement.id || document.activeElement.className);
		const tabTo = async (name) => {
			for (let i = 0; (await focus()) !== name; ++i) {
				assert.ok(i < 30, `${name} is not reached by Tab`);
				await page.keyboard.press("Tab");
			}
		};
		await page.keyboard.press("/");
		await page.keyboard.type("bloom toon");
		await tabTo("set-BloomToonIntensity");
		await page.keyboard.press("ArrowRight");
		await page.keyboard.press("ArrowRight");
		await settle(page, url);
		const { settings } = await (await ask(url, "state")).json();
		assert.ok(settings.find(({ name }) => name === "BloomToonIntensity").value > 0.1);
		await page.keyboard.press("Shift+Tab");
		for (let i = 0; (await focus()) !== "link blended"; ++i) {
			assert.ok(i < 6);
			await page.keyboard.press("Shift+Tab");
		}
		await page.keyboard.press("Enter");
		await until(page, () => /Base.*0\.675 → 0\.1.*camera/s.test(document.querySelector('[data-setting="BloomToonIntensity"] .why-value').textContent));
		await page.keyboard.press("Control+z"); // a press of a key is a step
		await page.keyboard.press("Control+z");
		await until(page, () => document.querySelector('[data-setting="BloomToonIntensity"] .number-box').value === "0.1");
	}));
});

long("a bad number is refused at its control, a name in a text that the config does not take, too", async () => {
	await withLive(toonBloom, [], (url) => onPage(url, async (page) => {
		await page.fill('[data-setting="BloomIntensity"] .number-box', "-1");
		await page.keyboard.press("Enter");
		assert.match(await page.textContent('[data-setting="BloomIntensity"] .refused'), /goes from 0 up/);
		await page.click("#tab-variables");
		await page.fill('[data-variable="r.BloomQuality"] .text-box', "many");
		await page.keyboard.press("Enter");
		await until(page, () => /DD1006: r\.BloomQuality must be a whole number, but is "many"/.test(document.querySelector("#variables").textContent));
		await page.click("#tab-settings");
		await page.fill("#settings-search", "dirt mask");
		await page.fill("#set-BloomDirtMask", "missing.png");
		await page.keyboard.press("Enter");
		await until(page, () => /DD\d{4}/.test(document.querySelector('[data-setting="BloomDirtMask"] .refused').textContent + document.querySelector("#faults").textContent));
		assert.equal(await page.evaluate(() => document.querySelector("#canvas").width > 300), true);
	}, { allow: /422/ }));
});

long("the camera walks among the volumes, and their weights and the settings follow", async () => {
	await withLive(source + "/configs/volumes_walk.json", [], (url) => onPage(url, async (page) => {
		await page.click("#tab-volumes");
		const weights = () => page.locator(".volume-card .weight").allTextContents();
		const before = await weights();
		const { x, y } = await page.locator(".camera .body").boundingBox();
		await page.mouse.move(x + 3, y + 3);
		await page.mouse.down();
		await page.mouse.move(x + 40, y + 1, { steps: 12 }); // beside the path, on which it then is
		await page.mouse.up();
		await settle(page, url);
		await until(page, (before) => [...document.querySelectorAll(".volume-card .weight")].map((one) => one.textContent).join() !== before, before.join());
		const { volumes, view } = await (await ask(url, "state")).json();
		assert.ok(view.location[0] > -135);
		const next = view.path.findIndex(([x]) => x > view.location[0]);
		const [from, to] = [view.path[next - 1], view.path[next]];
		const share = (view.location[0] - from[0]) / (to[0] - from[0]);
		[1, 2].forEach((axis) => assert.ok(Math.abs(from[axis] + share * (to[axis] - from[axis]) - view.location[axis]) < 0.2, `${view.location} is not on the path`));
		assert.deepEqual((await weights()).map((text) => text !== "does not act"), volumes.map(({ weight }) => weight > 0));
	}));
});

long("a pass, its texture, a texel's story and its trace, a price", async () => {
	await withLive(toonBloom, [], (url) => onPage(url, async (page) => {
		await page.click("#tab-passes");
		await page.click('#passes .link:has-text("ToonBloomMask")');
		await page.waitForSelector("#pass-detail");
		await page.click("#pass-detail .writes .link");
		await page.click("#texture-detail .look");
		await until(page, () => /^pass-\d+-ToonBloom/.test(document.querySelector("#picture-a").value));
		await page.selectOption("#picture-a", "now");
		await page.click("#probe-fold summary");
		await page.click("#canvas", { position: { x: 300, y: 200 } });
		await until(page, () => /Tonemap.*SV_Target0/s.test(document.querySelector("#probe-text pre")?.textContent));
		await page.click("#trace");
		await until(page, () => /usf/.test(document.querySelector("#probe-text pre")?.textContent));
		await page.click("#tab-price");
		await page.click("#measure");
		await page.waitForSelector("#price .point", { timeout: 60000 });
		assert.match(await page.textContent("#price table"), /start/);
	}));
});

long("nothing runs over the side, and axe finds nothing serious, in light and dark", async () => {
	await withLive(toonBloom, [], (url) => checkAxe(url, async (page) => {
		await page.evaluate(() => {
			document.querySelector("#graph-fold").open = true;
			document.querySelectorAll('[role="tabpanel"]').forEach((panel) => (panel.hidden = false));
		});
		await page.waitForSelector("#graph .pass");
	}));
});

const firefox = findFirefox();

long("Firefox: a slider by keys, the picture follows with the server's bytes, narrow and wide", { skip: firefox ? false : "there is no Firefox: apt-get install firefox-esr" }, async () => {
	await withLive(toonBloom, [], (url) => withFirefox(firefox, async (send) => {
		const ask_ = async (script) => (await send("WebDriver:ExecuteScript", { script, args: [] })).value;
		const press = (...keys) => send("WebDriver:PerformActions", { actions: [{ type: "key", id: "key", actions: keys.flatMap((value) => [{ type: "keyDown", value }, { type: "keyUp", value }]) }] });
		const waitFor = async (script) => {
			for (let tries = 0; tries < 200 && !(await ask_("return " + script)); ++tries) {
				await sleep(100);
			}
			assert.ok(await ask_("return " + script), script);
		};
		await send("WebDriver:SetWindowRect", { width: 1840, height: 1200 });
		await send("WebDriver:Navigate", { url });
		await waitFor("document.documentElement.dataset.ready === 'true' && !!document.querySelector('#facts dd')");
		const first = await ask_("return document.documentElement.dataset.revision");
		await ask_("document.querySelector('#set-BloomToonIntensity').focus()");
		await press("\uE014", "\uE014", "\uE014"); // right
		await waitFor(`document.documentElement.dataset.revision !== "${first}"`);
		await sleep(1500);
		const revision = await ask_("return document.documentElement.dataset.revision");
		const sent = new Uint8Array(await (await ask(url, `picture/${revision}?kind=final8`)).arrayBuffer());
		await ask_("document.querySelector('#canvas').focus()");
		await press("1");
		await sleep(300);
		assert.equal(Buffer.compare(Buffer.from(await ask_(`return (${readShown})([960, 540])`), "base64"), Buffer.from(sent)), 0);
		for (const [width, height] of [[1440, 900], [480, 900]]) { // a window of Firefox does not become narrower than 450
			await send("WebDriver:SetWindowRect", { width, height });
			for (let turn = 0; turn < 2; ++turn) {
				await press("t");
				await sleep(300);
				assert.deepEqual(await ask_(`return (${findSideways})()`), [], `at ${width}`);
				const { value: serious } = await send("WebDriver:ExecuteAsyncScript", { args: [], script: `${axeSource}
					const done = arguments[0];
					axe.run(document, { resultTypes: ["violations"] }).then(({ violations }) => done(violations
						.filter(({ impact }) => ["serious", "critical"].includes(impact)).map(({ id, nodes }) => id + ": " + nodes.map((node) => node.target).slice(0, 3))), (error) => done([String(error)]));` });
				assert.deepEqual(serious, [], `at ${width}`);
			}
		}
	}));
});
