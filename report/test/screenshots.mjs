// Takes the pictures of docs/report.md and README.md: node report/test/screenshots.mjs PAGE FULL_PAGE FRAME_PAGE STUDY_PAGE
// STUDY_PAGE_OF_JOBS DIFF_PAGE SEQUENCE_PAGE MATRIX_PAGE FOLDER (see there). CHROMIUM names the browser.
import { join, resolve } from "node:path";
import { onPage, startBrowser, stopBrowser, until } from "./harness.mjs";

const [plain, full, frame, study, jobs, diff, sequence, matrix, folder] = process.argv.slice(2).map((path) => resolve(path));

/** Each: its name, the page, what is done to it, further options of the window. */
const pictures = [
	["report_top", plain, async (page) => {
		await until(page, () => /pixels differ|same picture/.test(document.querySelector("#answer-changed").textContent));
	}, { viewport: { width: 1280, height: 1000 } }],
	["report_slider", plain, async (page) => {
		await page.locator("#picture").evaluate((node) => node.scrollIntoView({ behavior: "instant" }));
		await page.focus("#canvas");
		await page.keyboard.press("s");
	}, { colorScheme: "dark" }],
	["report_numbers", full, async (page) => {
		await page.locator("#picture").evaluate((node) => node.scrollIntoView({ behavior: "instant" }));
		await page.focus("#canvas");
		await page.keyboard.press("n");
		await page.keyboard.press("Shift+ArrowLeft");
	}, {}],
	["report_graph", plain, async (page) => {
		await page.locator("#graph").evaluate((node) => node.scrollIntoView({ behavior: "instant" }));
		await page.click('.order .pass[data-pass="10"] text');
	}, {}],
	["report_flow", frame, async (page) => {
		await page.click("#view-flow");
		await page.locator("#graph").evaluate((node) => node.scrollIntoView({ behavior: "instant" }));
	}, { colorScheme: "dark" }],
	["report_time", plain, async (page) => {
		await page.locator("#time").evaluate((node) => node.scrollIntoView({ behavior: "instant" }));
	}, {}],
	["report_study", study, async () => undefined, { viewport: { width: 1280, height: 700 } }],
	["report_panels", jobs, async (page) => {
		await page.keyboard.press("g");
	}, { viewport: { width: 1280, height: 1000 } }],
	["report_diff", diff, async () => undefined, {}],
	["report_sequence", sequence, async (page) => {
		await page.keyboard.press(".");
		await page.keyboard.press(".");
		await page.locator("#picture").evaluate((node) => node.scrollIntoView({ behavior: "instant" }));
	}, { colorScheme: "dark", viewport: { width: 1280, height: 1060 } }],
	["report_walk", sequence, async (page) => {
		for (let frame = 1; frame < 4; ++frame) {
			await page.keyboard.press(".");
		}
		await page.locator("#settings").evaluate((node) => node.scrollIntoView({ behavior: "instant" }));
	}, { viewport: { width: 1280, height: 690 } }],
	["report_matrix", matrix, async (page) => {
		await page.click('[data-cell="5.5 warnings"]');
		await page.locator("#answers").evaluate(() => scrollTo({ top: 0, behavior: "instant" }));
		await page.mouse.move(2, 400);
	}, { viewport: { width: 1280, height: 640 } }],
];

await startBrowser();
for (const [name, file, act, options] of pictures) {
	await onPage(file, async (page) => {
		await act(page);
		await page.waitForTimeout(300);
		await page.screenshot({ path: join(folder, name + ".png") });
	}, { viewport: { width: 1280, height: 840 }, deviceScaleFactor: 0.75, ...options });
}
await stopBrowser();
