// The page of a comparison in a browser: its answers, its pictures by mouse and keyboard, what differs.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { checkAxe, onPage, readCanvas, readData, runs, startBrowser, stopBrowser, until } from "./harness.mjs";

const file = runs + "/diff/diff.html";
const data = readData(file);
const off = data.diff.images.filter((image) => image.max);
const shownPair = (page, a, b) => until(page, ([a, b]) => document.querySelector("#picture-a").value === a && document.querySelector("#picture-b").value === b &&
	!!document.querySelector(`.strip [data-id="${a}"][aria-selected="true"]`), [a, b]);

before(startBrowser);
after(stopBrowser);

test("it says what differs, and where most", async () => {
	const worst = [...off].sort((a, b) => b.max - a.max)[0];
	await onPage(file, async (page) => {
		assert.match(await page.textContent("#answer-same"), new RegExp(`No: ${off.length} pictures? of ${data.diff.images.length}`));
		assert.match(await page.textContent("#answer-where"), new RegExp(`${worst.name}.*at ${worst.at.join(", ")}`));
		assert.match(await page.textContent("#answer-made"), /BloomIntensity: 3 → 1.5|BloomIntensity: 1.5 → 3/);
	});
});

test("A and B are over each other: slider, flip and difference by mouse and by key", async () => {
	await onPage(file, async (page) => {
		await shownPair(page, "a: final", "b: final");
		assert.equal(await page.getAttribute("#mode-slider", "aria-pressed"), "true");
		const seen = new Set([await readCanvas(page)]);
		for (const mode of ["a", "b", "difference", "side"]) {
			await page.click("#mode-" + mode);
			seen.add(await readCanvas(page));
		}
		assert.equal(seen.size, 5);
		await page.focus("#canvas");
		await page.keyboard.press("b");
		assert.equal(await page.getAttribute("#mode-b", "aria-pressed"), "true");
		await page.keyboard.press("b");
		assert.equal(await page.getAttribute("#mode-a", "aria-pressed"), "true");
	});
});

test("the table has all figures and leads to the pictures", async () => {
	await onPage(file, async (page) => {
		const rows = page.locator("#pictures tbody tr");
		assert.equal(await rows.count(), data.diff.images.length);
		const row = rows.filter({ hasText: off[0].name }).first();
		await row.locator("[data-show=error]").click();
		await shownPair(page, "error: " + off[0].name, "");
		await row.locator("[data-show=b]").focus();
		await page.keyboard.press("Enter");
		await shownPair(page, "a: " + off[0].name, "b: " + off[0].name);
	});
});

test("settings, passes and what they wrote", async () => {
	const { a, b } = data;
	const settings = Object.keys(a.run.settings).filter((name) => JSON.stringify(a.run.settings[name]) !== JSON.stringify(b.run.settings[name]));
	const wrote = (run) => new Map(run.passes.filter((pass) => pass.written).map((pass) => [pass.name, pass.written]));
	const [ofA, ofB] = [wrote(a.run), wrote(b.run)];
	const parts = [...ofA].filter(([name, textures]) => ofB.has(name) && Object.keys(textures).some((texture) => textures[texture] !== ofB.get(name)[texture]));
	await onPage(file, async (page) => {
		assert.deepEqual(await page.locator("#settings tbody tr td:first-child").allTextContents(), settings);
		assert.ok(parts.length > 3);
		await page.focus("#passes summary");
		await page.keyboard.press("Enter");
		assert.match(await page.textContent("#passes summary"), /wrote something else, first /);
		assert.equal(await page.locator("#passes details tbody tr").count(), parts.length);
		assert.ok(await page.locator("#time tbody tr").count() > 3);
	});
});

test("nothing runs over the side, and axe finds nothing serious, in light and dark", async () => {
	await checkAxe(file);
});
