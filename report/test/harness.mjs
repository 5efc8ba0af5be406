// What the browser tests share: pages opened from disk under watch, the data in them, and texels as another program
// reads them.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { createRequire } from "node:module";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { chromium } from "playwright-core";

/** Folder of runs that RunBrowserTests.sh made: plain, with an earlier run beside it, and full. */
export const runs = process.env.REPORT_RUNS;

/** Tests of the suite, and those that run with the long ones alone (RunBrowserTests.sh). */
export const [quick, long] = process.env.REPORT_LONG ? [test.skip, test] : [test, test.skip];

let browser;

/** The browser of serve.mjs where there is one, else one of this file's own. */
export async function startBrowser() {
	browser = process.env.BROWSER
		? await chromium.connect(process.env.BROWSER)
		: await chromium.launch({ executablePath: process.env.CHROMIUM, args: ["--no-sandbox"] });
}

export async function stopBrowser() {
	await browser.close();
}

/** Opens a file, or the page of a server, calls the test, and fails where the page wrote to the console, threw, or asked
 * for anything else. Options: of the browser's window; allow: a pattern of what it may write;
 * before: is called while the page makes itself. */
export async function onPage(file, test, { allow, before = () => undefined, ...options } = {}) {
	const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, colorScheme: "light", reducedMotion: "reduce", ...options });
	const page = await context.newPage();
	const faults = [];
	const url = file.startsWith("http") ? file : "file://" + file;
	const isOwn = (address) => (url === file ? address.startsWith(new URL(url).origin + "/") : address === url) || /^(data|blob):/.test(address);
	page.on("console", (message) => allow?.test(message.text()) || faults.push("console: " + message.text()));
	page.on("pageerror", (error) => faults.push("thrown: " + error.message));
	page.on("request", (request) => {
		if (!isOwn(request.url())) {
			faults.push("request: " + request.url());
		}
	});
	try {
		await page.goto(url);
		before(page);
		await page.waitForSelector("html[data-ready]");
		await until(page, () => !document.querySelector("#facts") || !!document.querySelector("#facts dd"));
		await test(page);
		assert.deepEqual(faults, []);
	} finally {
		await context.close();
	}
}

/** Until a function of the page is true; asked from outside, for the page allows no text to become code. */
export async function until(page, holds, argument) {
	for (const end = Date.now() + 30000; !(await page.evaluate(holds, argument)); ) {
		assert.ok(Date.now() < end, `it never came to hold: ${holds} of ${argument}`);
		await new Promise((done) => setTimeout(done, 20));
	}
}

/** The text of axe. */
export const axeSource = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** What a window, of the size that it has, cannot show without sideways scrolling: the page, or a box on it; beside what is a
 * strip by its nature (film strip, the graph as it flows). In a narrow window also pictures and charts that are mere slivers,
 * and names that are cut. A function of the page. */
export function findSideways() {
	const root = document.scrollingElement;
	const faults = root.scrollWidth > innerWidth ? [`the page is ${root.scrollWidth} wide`] : [];
	const allowed = ".graph-view:has(.flow)" + (innerWidth > 760 ? ", .strip, .graph-view, .table" : "");
	for (const box of document.querySelectorAll("main *")) {
		if (box.scrollWidth > box.clientWidth + 1 && ["auto", "scroll"].includes(getComputedStyle(box).overflowX) && !box.matches(allowed)) {
			faults.push(`${box.id || box.className} scrolls by ${box.scrollWidth - box.clientWidth}`);
		}
		if (getComputedStyle(box).textOverflow === "ellipsis" && box.scrollWidth > box.clientWidth) {
			faults.push(`"${box.textContent}" is cut`);
		}
	}
	for (const picture of document.querySelectorAll("#canvas, .chart, .plot-box svg, .order")) {
		const { left, right, height } = picture.getBoundingClientRect();
		if (height && !picture.closest(".panel") && (left < 0 || right > innerWidth || height < 40 || right - left < Math.min(250, innerWidth * 0.6))) {
			faults.push(`${picture.id || picture.getAttribute("class")} is from ${left} to ${right}, ${height} high`);
		}
	}
	return faults;
}

/** At 390 and 1440 pixels of width nothing scrolls sideways, and axe finds nothing serious, in light and dark, which look
 * different. Act: what is done to the page before. */
export async function checkAxe(file, act = async () => undefined) {
	const papers = new Set();
	for (const colorScheme of ["light", "dark"]) {
		for (const [width, height] of [[1440, 900], [390, 844]]) {
			await onPage(file, async (page) => {
				await act(page);
				papers.add(await page.evaluate(() => getComputedStyle(document.body).backgroundColor));
				await page.mouse.move(2, 2);
				for (const open of width < 760 ? [false, true] : [true]) {
					await page.evaluate((open) => document.querySelectorAll(".fold").forEach((fold) => (fold.open = open)), open);
					await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
					assert.deepEqual(await page.evaluate(findSideways), [], `at ${width}`);
				}
				await page.evaluate(axeSource);
				const { violations } = await page.evaluate(() => axe.run(document, { resultTypes: ["violations"] }));
				const serious = violations.filter((violation) => ["serious", "critical"].includes(violation.impact));
				assert.deepEqual(serious.map((violation) => `${violation.id}: ${violation.nodes.map((node) => node.target).slice(0, 3)}`), []);
			}, { colorScheme, viewport: { width, height } });
		}
	}
	assert.equal(papers.size, 2);
}

export function readData(file) {
	const page = readFileSync(file, "utf8");
	const from = page.indexOf('id="data">') + 'id="data">'.length;
	return JSON.parse(page.slice(from, page.indexOf("</script>", from)));
}

/** Writes the page of other data into a file that goes away with the test. */
export async function withData(data, test) {
	const folder = mkdtempSync(join(tmpdir(), "drydock_report_"));
	try {
		const template = readFileSync(new URL("../page.html", import.meta.url), "utf8");
		const file = join(folder, "report.html");
		writeFileSync(file, template.replace('"drydock-report-data"', () => JSON.stringify(data).replaceAll("<", "\\u003c")));
		await test(file);
	} finally {
		rmSync(folder, { recursive: true });
	}
}

/** A texel's values as oiiotool reads them from a file: floats of an EXR, codes of a PNG. */
export function readTexel(file, x, y) {
	const folder = mkdtempSync(join(tmpdir(), "drydock_texel_"));
	try {
		const cut = join(folder, "cut" + file.slice(file.lastIndexOf(".")));
		execFileSync("oiiotool", [file, "--cut", `1x1+${x}+${y}`, "-o", cut]);
		const line = execFileSync("oiiotool", ["--dumpdata", cut], { encoding: "utf8" }).match(/Pixel \([^)]*\): ([^(\n]*)/)[1];
		return line.trim().split(/\s+/).map(Number);
	} finally {
		rmSync(folder, { recursive: true });
	}
}

/** What the viewer's canvas shows, once it has been painted: its bytes, or one pixel of it. */
export async function readCanvas(page, share) {
	return page.evaluate(async (share) => {
		await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
		const shown = document.querySelector("#canvas");
		const canvas = new OffscreenCanvas(shown.width, shown.height);
		const context = canvas.getContext("2d", { willReadFrequently: true });
		context.drawImage(shown, 0, 0);
		if (share) {
			return [...context.getImageData(Math.floor(share[0] * canvas.width), Math.floor(share[1] * canvas.height), 1, 1).data];
		}
		const bytes = context.getImageData(0, 0, canvas.width, canvas.height).data;
		const digest = await crypto.subtle?.digest("SHA-256", bytes);
		return digest ? [...new Uint8Array(digest)].join() : bytes.reduce((sum, byte, i) => (sum * 31 + byte + i) % 4294967291, 7);
	}, share);
}

export async function readProbe(page) {
	return page.evaluate(() => ({
		at: document.querySelector("#probe h3").textContent.match(/\d+/g).map(Number),
		values: [...document.querySelectorAll("#probe td[data-value]")].map((cell) => Number(cell.dataset.value)),
	}));
}
