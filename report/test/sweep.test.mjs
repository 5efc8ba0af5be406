// The page of a sweep in a browser: its table by figures, cells that open pictures, and plots.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { checkAxe, onPage, readData, runs, startBrowser, stopBrowser, until, withData } from "./harness.mjs";

const file = runs + "/sweep/sweep.html";
const data = readData(file);
const { rows, axes, figures } = data.sweep;

before(startBrowser);
after(stopBrowser);

test("the table has a cell for each task, and those that are excluded are empty", async () => {
	await onPage(file, async (page) => {
		assert.equal(await page.locator("#grid .cell").count(), rows.length);
		assert.equal(await page.locator("#grid tbody tr").count(), 4);
		assert.equal(rows.length, 10);
		assert.deepEqual(axes.map((axis) => axis.name), ["engine", "r.BloomQuality", "BloomIntensity"]);
	});
});

test("a list chooses the figure", async () => {
	await onPage(file, async (page) => {
		for (const figure of [figures.find((name) => name === "brightness"), "seconds"]) {
			await page.selectOption("#figure", figure);
			const text = await page.textContent('[data-cell="1"]');
			const value = figure === "seconds" ? data.seconds[1] * 1000 : rows[1].figures[figure];
			assert.ok(Math.abs(parseFloat(text) * (text.endsWith(" s") ? 1000 : 1) - value) < 0.02 * value, text);
		}
	});
});

test("a cell opens its picture, and the one before becomes B", async () => {
	await onPage(file, async (page) => {
		await page.click('[data-cell="2"]');
		await until(page, () => document.querySelector("#picture-a").value === "2");
		await page.click('[data-cell="5"]');
		await until(page, () => document.querySelector("#picture-a").value === "5" && document.querySelector("#picture-b").value === "2");
		assert.ok((await page.textContent("#cell-detail")).includes(rows[5].task));
		assert.equal(await page.locator('.cell[aria-pressed="true"]').count(), 1);
	});
});

test("plots show each figure over each axis", async () => {
	await onPage(file, async (page) => {
		assert.equal(await page.locator("#plots svg").count(), 3 * figures.length);
		assert.equal(await page.locator("#plots svg path.line").count() % figures.length, 0);
	});
});

test("a sweep of studies has no pictures, and pieces have a table", async () => {
	const piece = { task: rows[0].task, frames: "3-4", lead: "1-2", different: 1, max: 0.5, rms: 0.01 };
	await withData({ ...data, pictures: [], sweep: { ...data.sweep, pieces: [piece] } }, (some) => onPage(some, async (page) => {
		assert.equal(await page.locator("#picture").count(), 0);
		assert.match(await page.textContent("#pieces tbody tr"), /3-4.*1-2.*0.01.*0.5/);
	}));
});

test("nothing runs over the side, and axe finds nothing serious, in light and dark", async () => {
	await checkAxe(file);
});
