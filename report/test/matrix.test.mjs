// The page of a matrix in a browser: its table by mouse and keyboard, what lies behind cells, the way to messages.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { checkAxe, onPage, readData, runs, startBrowser, stopBrowser, until, withData } from "./harness.mjs";

const file = runs + "/matrix/matrix.html";
const data = readData(file);
const { versions } = data.matrix;
const [first, second] = versions;

before(startBrowser);
after(stopBrowser);

test("the table has a row for each version, and says what it comes to", async () => {
	await onPage(file, async (page) => {
		assert.equal(await page.locator("#table tbody tr").count(), versions.length);
		assert.ok((await page.textContent("#answer-worked")).includes(data.matrix.summary));
		assert.equal(await page.textContent(`[data-cell="${second.engine} warnings"]`), "DD2070");
		assert.equal(await page.textContent(`[data-cell="${second.engine} engine"]`), second.inEngine.answer);
	});
});

test("a cell opens by click and by Enter, and arrows lead from one to the next", async () => {
	await onPage(file, async (page) => {
		await page.click(`[data-cell="${second.engine} warnings"]`);
		assert.match(await page.textContent("#cell-detail h3"), new RegExp(`Engine ${second.engine}: warnings`));
		assert.ok((await page.textContent("#cell-detail")).includes("which that engine never calls"));
		await page.keyboard.press("ArrowUp");
		await page.keyboard.press("Enter");
		assert.match(await page.textContent("#cell-detail h3"), new RegExp(`Engine ${first.engine}: warnings`));
		await page.keyboard.press("ArrowRight");
		await page.keyboard.press("Enter");
		assert.match(await page.textContent("#cell-detail h3"), /picture$/);
		assert.equal(await page.locator('.cell[aria-pressed="true"]').count(), 1);
	});
});

test("messages are told once, and cell and message lead to each other", async () => {
	await onPage(file, async (page) => {
		await page.click(`[data-cell="${second.engine} warnings"]`);
		await page.click("#cell-detail .said a");
		assert.equal(await page.locator("#messages tr:target").count(), 1);
		assert.ok((await page.textContent("#messages tr:target")).includes("DD2070"));
		await page.click(`[data-cell="${first.engine} builds"]`);
		await page.locator("#messages tr:target .link").first().click();
		assert.match(await page.textContent("#cell-detail h3"), new RegExp(`Engine ${second.engine}: warnings`));
	});
});

test("the pictures that differ stand over each other", async () => {
	await onPage(file, async (page) => {
		assert.deepEqual(data.pictures.map((picture) => picture.id), [first.engine, second.engine]);
		await page.click(`[data-cell="${first.engine} picture"]`);
		await until(page, (id) => document.querySelector("#picture-a").value === id, first.engine);
		assert.equal(await page.inputValue("#picture-b"), second.engine);
		await page.click("#show-version");
		await page.focus("#canvas");
		await page.keyboard.press("d");
		assert.equal(await page.getAttribute("#mode-difference", "aria-pressed"), "true");
	});
});

test("a plugin that does not build has no picture, and its message first", async () => {
	const message = { code: null, file: "MyTint.cpp", line: 41, where: "", text: "'X' was not declared <here>" };
	const broken = { ...data, pictures: [], matrix: { ...data.matrix, passed: false, versions: versions.map((version) => ({
		...version, builds: false, firstError: message, run: null, picture: null, firstDifference: null })) } };
	await withData(broken, (some) => onPage(some, async (page) => {
		assert.equal(await page.locator("#picture").count(), 0);
		assert.ok((await page.textContent("#cell-detail")).includes(message.text));
		assert.equal(await page.locator("#messages tbody tr").count(), 1);
		assert.match(await page.textContent("#messages tbody tr"), /MyTint.cpp:41/);
	}));
});

test("nothing runs over the side, and axe finds nothing serious, in light and dark", async () => {
	await checkAxe(file);
});
