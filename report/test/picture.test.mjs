// The picture section in a browser: every control by mouse and by keyboard, and values against the files' own.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { deflateSync } from "node:zlib";
import { onPage, readCanvas, readData, readProbe, readTexel, runs, startBrowser, stopBrowser, until, withData } from "./harness.mjs";

const plain = runs + "/plain/report.html";
const full = runs + "/full/report.html";

before(startBrowser);
after(stopBrowser);

async function pickPicture(page, select, id) {
	await page.selectOption(select, id);
	await until(page, (id) => !!document.querySelector(`.strip [data-id="${id}"][aria-selected="true"]`), id);
}

/** To the digits that oiiotool prints. */
function assertSame(probe, texel) {
	assert.equal(probe.values.length, texel.length);
	texel.forEach((value, i) => assert.ok(Math.abs(value - probe.values[i]) <= Math.abs(value) * 1e-6, `at ${probe.at}: ${value} and ${probe.values[i]}`));
}

async function isPressed(page, id) {
	return (await page.getAttribute(id, "aria-pressed")) === "true";
}

test("the value under the cursor is the EXR's texel", async () => {
	await onPage(full, async (page) => {
		const canvas = await page.locator("#canvas").boundingBox();
		for (const [id, file] of [["scene", "scene_linear.exr"], ["final", "final.exr"]]) {
			await pickPicture(page, "#picture-a", id);
			for (const [x, y] of [[0.3, 0.4], [0.62, 0.55], [0.9, 0.81]]) {
				await page.mouse.move(canvas.x + x * canvas.width, canvas.y + y * canvas.height);
				const probe = await readProbe(page);
				assertSame(probe, readTexel(`${runs}/full/${file}`, ...probe.at).slice(0, 3));
			}
		}
	});
});

test("shift and arrows move the probe by a texel, also of a dump that has its own corner", async () => {
	const data = readData(full);
	const dump = data.pictures.find((picture) => picture.role === "dump");
	await onPage(full, async (page) => {
		await pickPicture(page, "#picture-a", dump.id);
		await page.focus("#canvas");
		await page.keyboard.press("Shift+ArrowRight");
		const first = await readProbe(page);
		await page.keyboard.press("Shift+ArrowRight");
		await page.keyboard.press("Shift+ArrowUp");
		const second = await readProbe(page);
		assert.deepEqual(second.at, [first.at[0] + 1, first.at[1] - 1]);
		const texel = readTexel(`${runs}/full/passes/${dump.id}.exr`, ...second.at);
		assertSame(second, texel);
	});
});

test("without values the probe reads the PNG's codes", async () => {
	await onPage(plain, async (page) => {
		const canvas = await page.locator("#canvas").boundingBox();
		await page.mouse.move(canvas.x + canvas.width * 0.4, canvas.y + canvas.height * 0.6);
		const probe = await readProbe(page);
		assert.deepEqual(probe.values.map((value) => Math.round(value * 255)), readTexel(runs + "/plain/final.png", ...probe.at));
	});
});

test("B flips in place by key and by mouse, and back to the same bits", async () => {
	await onPage(plain, async (page) => {
		const a = await readCanvas(page);
		await page.focus("#canvas");
		await page.keyboard.press("b");
		const b = await readCanvas(page);
		assert.notEqual(a, b);
		assert.ok(await isPressed(page, "#mode-b"));
		await page.keyboard.press("b");
		assert.equal(await readCanvas(page), a);
		await page.click("#mode-b");
		assert.equal(await readCanvas(page), b);
		await page.click("#mode-a");
		assert.equal(await readCanvas(page), a);
	});
});

test("the slider shows A at its left and B at its right, by mouse and by keys", async () => {
	await onPage(plain, async (page) => {
		const at = (share) => readCanvas(page, [share, 0.5]);
		const [a, b] = [[await at(0.2), await at(0.8)], []];
		await page.click("#mode-b");
		b.push(await at(0.2), await at(0.8));
		await page.focus("#canvas");
		await page.keyboard.press("s");
		assert.deepEqual([await at(0.2), await at(0.8)], [a[0], b[1]]);
		for (let i = 0; i < 8; ++i) {
			await page.keyboard.press("]");
		}
		assert.deepEqual(await at(0.8), a[1]);
		const canvas = await page.locator("#canvas").boundingBox();
		await page.mouse.move(canvas.x + canvas.width * 0.9, canvas.y + 200);
		await page.mouse.down();
		await page.mouse.move(canvas.x + canvas.width * 0.1, canvas.y + 200, { steps: 4 });
		await page.mouse.up();
		assert.deepEqual(await at(0.2), b[0]);
	});
});

test("side by side both move together", async () => {
	await onPage(full, async (page) => {
		await page.selectOption("#picture-b", "final");
		await until(page, () => !document.querySelector("#mode-side").disabled);
		await page.click("#mode-side");
		await page.focus("#canvas");
		for (const key of ["+", "+", "ArrowLeft", "ArrowDown"]) {
			await page.keyboard.press(key);
		}
		for (const y of [0.3, 0.5, 0.7]) {
			assert.deepEqual(await readCanvas(page, [0.2, y]), await readCanvas(page, [0.7, y]));
		}
	});
});

test("the difference has figures, and its gain brightens it", async () => {
	await onPage(plain, async (page) => {
		await page.focus("#canvas");
		await page.keyboard.press("d");
		const dark = await readCanvas(page);
		assert.match(await page.textContent("#facts"), /A − B[\d,]+ pixels? \(/);
		await page.focus("#gain");
		await page.keyboard.press("ArrowRight");
		assert.equal(await page.textContent("#gain + output"), "× 2");
		assert.notEqual(await readCanvas(page), dark);
		await page.click("#mode-a");
		assert.ok(!(await page.locator("#gain").isVisible()));
	});
});

test("exposure, gamma, channel, false colour and range change the picture, and reset takes it all back", async () => {
	await onPage(plain, async (page) => {
		const seen = new Set([await readCanvas(page)]);
		const [original] = seen;
		const expectNew = async (what) => {
			const canvas = await readCanvas(page);
			assert.ok(!seen.has(canvas), what + " changes nothing");
			seen.add(canvas);
		};
		await page.focus("#exposure");
		await page.keyboard.press("ArrowRight");
		await expectNew("exposure by its slider");
		await page.focus("#canvas");
		await page.keyboard.press("e");
		await expectNew("exposure by key");
		await page.selectOption("#gamma", "1.8");
		await expectNew("gamma");
		await page.selectOption("#channel", "0");
		await expectNew("channel");
		assert.ok(!(await page.locator("#scale").isVisible()));
		await page.click("#false-color");
		await expectNew("false colour by mouse");
		assert.ok(await page.locator("#scale").isVisible());
		await page.fill("#high", "0.5");
		await expectNew("range");
		assert.match(await page.textContent("#scale .ends"), /^0/);
		await page.focus("#canvas");
		await page.keyboard.press("r");
		await expectNew("stretch by key");
		assert.notEqual(await page.inputValue("#low"), "0");
		await page.keyboard.press("x");
		assert.equal(await readCanvas(page), original);
		assert.equal(await page.inputValue("#exposure"), "0");
		await page.click("#stretch");
		await expectNew("stretch by mouse");
		await page.click("#reset");
		assert.equal(await readCanvas(page), original);
	});
});

test("NaN, infinities and negative values stand out, with their counts", async () => {
	const data = readData(full);
	const scene = data.pictures.find((picture) => picture.id === "scene");
	// Four texels side by side, one channel: 0.5, NaN, infinity, -1, as halves, high bytes first.
	Object.assign(scene, { size: [4, 1], extent: [4, 1], channels: ["R"], figures: { min: [-1], max: [0.5], nan: 1, infinite: 1, negative: 1 },
		values: { type: "half", zlib: deflateSync(Buffer.from([0x38, 0x7e, 0x7c, 0xbc, 0, 0, 0, 0])).toString("base64") } });
	await withData(data, (file) => onPage(file, async (page) => {
		await pickPicture(page, "#picture-a", "scene");
		const colors = async () => {
			const list = []; // beside the numbers
			for (const texel of [0, 1, 2, 3]) {
				list.push(await readCanvas(page, [(texel + 0.1) / 4, 0.5]));
			}
			return list;
		};
		await page.focus("#canvas");
		await page.keyboard.press("o");
		const [plainColor, ...odd] = await colors();
		assert.equal(plainColor[0], plainColor[1]);
		assert.deepEqual(odd, [[255, 0, 220, 255], [255, 230, 0, 255], [0, 150, 255, 255]]);
		assert.match(await page.textContent("#facts"), /1 · 1 · 1/);
		await page.click("#odd");
		assert.notDeepEqual((await colors())[1], odd[0]);
		assert.match(await page.textContent("#answer-finite"), /hold NaN or infinities/);
	}));
});

test("the wheel, a double click and keys zoom to texels with numbers, and fit goes back", async () => {
	await onPage(plain, async (page) => {
		const zoom = async () => Number((await page.textContent("#zoom")).split(": ")[1]);
		const fitted = await readCanvas(page);
		const before = await zoom();
		const canvas = await page.locator("#canvas").boundingBox();
		await page.mouse.move(canvas.x + 300, canvas.y + 200);
		await page.mouse.wheel(0, -480);
		await until(page, (zoom) => Number(document.querySelector("#zoom").textContent.split(": ")[1]) > zoom, before);
		await page.click("#fit");
		await page.mouse.move(0, 0);
		await page.keyboard.press("Tab");
		assert.equal(await readCanvas(page), fitted);
		await page.dblclick("#canvas");
		assert.equal(await zoom(), 64);
		await page.focus("#canvas");
		await page.keyboard.press("f");
		assert.equal(await zoom(), before);
		await page.keyboard.press("1");
		assert.equal(await zoom(), 1);
		await page.keyboard.press("-");
		assert.ok((await zoom()) < 1);
		await page.click("#pixels");
		assert.equal(await zoom(), 64);
	});
});

test("keys of the picture act without a click on it first", async () => {
	await onPage(plain, async (page) => {
		for (const [key, mode] of [["s", "slider"], ["d", "difference"], ["i", "side"], ["b", "b"], ["a", "a"]]) {
			await page.keyboard.press(key);
			assert.ok(await isPressed(page, "#mode-" + mode), key);
		}
		await page.keyboard.press("c");
		assert.ok(await isPressed(page, "#false-color"));
		await page.keyboard.press("n");
		assert.match(await page.textContent("#zoom"), /: 64$/);
		await page.locator("#messages").scrollIntoViewIfNeeded();
		await page.keyboard.press("f");
		const { y, height } = await page.locator("#canvas").boundingBox();
		assert.ok(y >= 0 && y + height <= 900, "what a key does is seen");
		await page.focus("#search");
		await page.keyboard.press("s");
		assert.equal(await page.inputValue("#search"), "s");
		assert.ok(await isPressed(page, "#mode-a"));
	});
});

test("the film strip chooses A, and with shift B", async () => {
	const id = readData(plain).pictures.find((picture) => picture.role === "thumbnail").id;
	await onPage(plain, async (page) => {
		await page.click(`.strip [data-id="${id}"]`);
		await until(page, (id) => document.querySelector("#picture-a").value === id, id);
		await page.click('.strip [data-id="scene"]', { modifiers: ["Shift"] });
		await until(page, () => document.querySelector("#picture-b").value === "scene");
		assert.equal(await page.inputValue("#picture-a"), id);
	});
});
