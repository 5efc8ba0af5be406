// Takes the pictures of docs/report.md: node report/test/screenshots.mjs PAGE FULL_PAGE FRAME_PAGE STUDY_PAGE FOLDER (see
// there). CHROMIUM names the browser.
import { join, resolve } from "node:path";
import { onPage, startBrowser, stopBrowser } from "./harness.mjs";

const [plain, full, frame, study, folder] = process.argv.slice(2).map((path) => resolve(path));

/** Each: its name, the page, what is done to it, further options of the window. */
const pictures = [
	["report_top", plain, async (page) => {
		await page.waitForFunction(() => /pixels differ|same picture/.test(document.querySelector("#answer-changed").textContent));
	}, {}],
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
