// The page of a sequence in a browser: its frames by every control, the plots, the walk.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { checkAxe, onPage, readCanvas, readData, runs, startBrowser, stopBrowser, until, withData } from "./harness.mjs";

const file = runs + "/walk/sequence.html";
const data = readData(file);
const { frames } = data.sequence;
const settings = (page) => page.walk.chart.panels.filter((panel) => panel.title);
const at = (page, index) => until(page, ([index, frame]) => document.querySelector("#scrubber").value === String(index) &&
	!!document.querySelector(`.strip [data-id="${frame}"][aria-selected="true"]`), [index, frames[index].frame]);

before(startBrowser);
after(stopBrowser);

test("the frame is chosen by slider, buttons, keys, strip and plots", async () => {
	await onPage(file, async (page) => {
		await at(page, 0);
		const first = await readCanvas(page);
		await page.focus("#scrubber");
		await page.keyboard.press("ArrowRight");
		await at(page, 1);
		assert.notEqual(await readCanvas(page), first);
		await page.click("#later");
		await at(page, 2);
		await page.click("#earlier");
		await at(page, 1);
		await page.focus("body");
		await page.keyboard.press(".");
		await at(page, 2);
		await page.keyboard.press(",");
		await at(page, 1);
		await page.click(`.strip [data-id="${frames[5].frame}"]`);
		await at(page, 5);
		assert.match(await page.textContent("#where"), new RegExp(`Frame ${frames[5].frame}, ${(frames[5].frame / data.framesPerSecond).toFixed(2)} s`));
		const plot = page.locator('[data-chart="mean"]');
		await plot.focus();
		await page.keyboard.press("Home");
		await at(page, 0);
		await page.keyboard.press("End");
		await at(page, frames.length - 1);
		const box = await plot.boundingBox();
		await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
		await until(page, (last) => document.querySelector("#scrubber").valueAsNumber > 1 && document.querySelector("#scrubber").valueAsNumber < last - 1, frames.length - 1);
	});
});

test("plots tell the figures of the frame", async () => {
	await onPage(file, async (page) => {
		const shown = async (chart) => Number((await page.locator(".plot-cell", { has: page.locator(`[data-chart="${chart}"]`) }).locator("output strong").textContent()).split(" ")[0]);
		for (const index of [0, 3]) {
			await page.locator('[data-chart="mean"]').focus();
			await page.keyboard.press("Home");
			for (let step = 0; step < index; ++step) {
				await page.keyboard.press("ArrowRight");
			}
			assert.ok(Math.abs(await shown("mean") - data.figures[index].mean) < 1e-4);
			assert.ok(Math.abs(await shown("exposure") - frames[index].exposure.scale) < 1e-4);
		}
	});
});

test("B follows as the frame before, until it is let go", async () => {
	await onPage(file, async (page) => {
		await page.click("#later");
		await page.click("#later");
		await at(page, 2);
		assert.equal(await page.inputValue("#picture-b"), String(frames[1].frame));
		await page.keyboard.press("k");
		assert.equal(await page.getAttribute("#follow", "aria-pressed"), "false");
		await page.click("#follow");
		assert.equal(await page.getAttribute("#follow", "aria-pressed"), "true");
		await page.keyboard.press("k");
		await page.click("#later");
		await at(page, 3);
		assert.equal(await page.inputValue("#picture-b"), String(frames[1].frame));
	});
});

test("it plays and stops", async () => {
	await onPage(file, async (page) => {
		await page.keyboard.press("p");
		assert.equal(await page.textContent("#play"), "Stop");
		await until(page, () => document.querySelector("#scrubber").valueAsNumber >= 3);
		await page.click("#play");
		assert.equal(await page.getAttribute("#play", "aria-pressed"), "false");
	});
});

test("the walk has every setting that changes, and follows the frame", async () => {
	await onPage(file, async (page) => {
		assert.equal(await page.locator("#walk .plot-box").count(), settings(data).length + 1);
		const weights = page.locator('#walk [data-chart="weights"]');
		const before = Number(await weights.getAttribute("aria-valuenow"));
		await page.click("#later");
		await at(page, 1);
		const now = Number(await weights.getAttribute("aria-valuenow"));
		assert.ok(now > before);
		assert.ok(Math.abs(data.walk.chart.panels[0].series[0].line[now][0] - data.walk.chart.marks[1].value) < 1);
		await weights.focus();
		await page.keyboard.press("ArrowRight");
		assert.equal(Number(await weights.getAttribute("aria-valuenow")), now + 1);
	});
});

test("frames without a picture show the one before, and the page says so", async () => {
	const thinned = { ...data, pictures: data.pictures.filter((_, i) => i % 2 === 0) };
	await withData(thinned, (some) => onPage(some, async (page) => {
		assert.match(await page.textContent("#picture .note"), new RegExp(`Pictures of ${thinned.pictures.length} of the ${frames.length} frames`));
		await page.click("#later");
		await until(page, () => /the picture is of/.test(document.querySelector("#where").textContent));
		assert.equal(await page.inputValue("#picture-a"), String(frames[0].frame));
	}));
});

test("a run of one of its frames has the walk among its settings", async () => {
	await onPage(runs + "/walk4/report.html", async (page) => {
		assert.equal(await page.locator("#settings #walk .plot-box").count(), settings(readData(runs + "/walk4/report.html")).length + 1);
		assert.match(await page.textContent("#settings .walk .note"), /the line is where frame 4 is/);
	});
});

test("nothing runs over the side, and axe finds nothing serious, in light and dark", async () => {
	await checkAxe(file);
});
