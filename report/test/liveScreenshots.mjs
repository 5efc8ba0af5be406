// Takes the pictures of docs/live.md: CHROMIUM=/usr/bin/chromium DRYDOCK=$PWD/build/release/bin/drydock node report/test/liveScreenshots.mjs
// FOLDER, from the root of the sources.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { onPage, startBrowser, stopBrowser } from "./harness.mjs";
import { drydock, withLive } from "./liveServer.mjs";

const folder = resolve(process.argv[2]);
const work = mkdtempSync(join(tmpdir(), "drydock_live_"));

async function drag(page, selector, from, to) {
	const { x, y, width, height } = await page.locator(selector).boundingBox();
	await page.mouse.move(x + width * from[0], y + height * from[1]);
	await page.mouse.down();
	for (let step = 1; step <= 20; ++step) {
		await page.mouse.move(x + width * (from[0] + ((to[0] - from[0]) * step) / 20), y + height * (from[1] + ((to[1] - from[1]) * step) / 20));
		await page.waitForTimeout(60);
	}
	await page.mouse.up();
	await page.mouse.move(2, 2);
}

/** Each: its name, the config, what is done to the page, further options of the window. */
const pictures = [
	["live_settings", "configs/toon_bloom.json", async (page) => {
		await page.fill("#settings-search", "bloom intensity");
		await page.locator('[data-setting="BloomToonIntensity"]').scrollIntoViewIfNeeded();
		await drag(page, "#set-BloomToonIntensity", [0.015, 0.5], [0.1, 0.5]);
		await page.waitForTimeout(700);
		await page.click('[data-setting="BloomToonIntensity"] .blended');
		await page.focus("#canvas");
		await page.keyboard.press("s");
	}, { viewport: { width: 1440, height: 820 } }],
	["live_volumes", "configs/volumes_walk.json", async (page) => {
		await page.click("#tab-volumes");
		const camera = await page.locator(".camera .body").boundingBox();
		const view = await page.locator(".top-view svg").boundingBox();
		const at = [(camera.x + camera.width / 2 - view.x) / view.width, (camera.y + camera.height / 2 - view.y) / view.height];
		await drag(page, ".top-view svg", at, [0.5, 0.53]);
	}, { colorScheme: "dark", viewport: { width: 1440, height: 820 } }],
	["live_mistake", join(work, "Patch/Patch.json"), async (page) => {
		const shader = join(work, "Patch/Engine/Shaders/Private/PostProcessTonemap.usf");
		writeFileSync(shader, readFileSync(shader, "utf8").replace("Tonemap(SvPosition.xy);", "Tonemap(SvPosition.xy).rgbz;"));
		await page.waitForSelector("#faults div");
	}, { viewport: { width: 390, height: 760 }, deviceScaleFactor: 1 }],
];

execFileSync(drydock, ["overlay", "new", "Patch", "--pass", "Tonemap"], { cwd: work, stdio: "ignore" });
await startBrowser();
for (const [name, config, act, options] of pictures) {
	await withLive(config, [], (url) => onPage(url, async (page) => {
		await page.waitForTimeout(1000);
		await act(page);
		await page.waitForTimeout(1500);
		await page.screenshot({ path: join(folder, name + ".png") });
	}, { deviceScaleFactor: 0.75, ...options }));
}
await stopBrowser();
rmSync(work, { recursive: true });
