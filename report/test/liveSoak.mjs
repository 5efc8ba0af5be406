// Uses `drydock live` as a person who tries everything would, for as long as is asked, and prints what the server's memory does:
// sliders are dragged, ticks set, steps undone, states pinned, texels probed, prices measured, the camera moved.
//
//     CHROMIUM=/usr/bin/chromium DRYDOCK=build/release/bin/drydock SOURCE=$PWD node report/test/liveSoak.mjs SECONDS CONFIG...
//
// Exit code 1 where the memory at the end is more than 1.2 times that after a tenth of the time.
import { readFileSync, readdirSync } from "node:fs";
import { basename } from "node:path";
import { onPage, startBrowser, stopBrowser } from "./harness.mjs";
import { ask, withLive } from "./liveServer.mjs";

const [seconds, configs] = [Number(process.argv[2]), process.argv.slice(3)];

/** Megabytes of the process that runs the frames, which the server's own process keeps. */
function readMemory(parent) {
	const stat = (pid) => readFileSync(`/proc/${pid}/stat`, "utf8").replace(/.*\) /s, "").split(" ");
	const kept = readdirSync("/proc").filter((pid) => /^\d+$/.test(pid)).find((pid) => {
		try {
			return Number(stat(pid)[1]) === parent;
		} catch {
			return false; // it has just ended
		}
	});
	return Number(/VmRSS:\s+(\d+)/.exec(readFileSync(`/proc/${kept}/status`, "utf8"))[1]) / 1024;
}

/** The same numbers for each run: each from 0 up to 1. */
function makeRandom(seed) {
	return () => {
		seed = (seed * 1664525 + 1013904223) % 2 ** 32;
		return seed / 2 ** 32;
	};
}

async function use(page, url, random, count) {
	const pick = (list) => list[Math.floor(random() * list.length)];
	const visible = async (selector) => (await page.locator(selector).all()).slice(0, 60);
	const drag = async (locator) => {
		const box = await locator.boundingBox();
		if (!box) {
			return;
		}
		const y = box.y + box.height / 2;
		await page.mouse.move(box.x + box.width * random(), y);
		await page.mouse.down();
		for (let step = 0; step < 20; ++step) {
			await page.mouse.move(box.x + box.width * Math.min(Math.max(random(), 0.01), 0.99), y);
			count();
		}
		await page.mouse.up();
	};
	const acts = [
		...Array(6).fill(async () => {
			await page.click("#tab-settings");
			await page.fill("#settings-search", pick(["bloom", "vignette", "exposure", "tone", "color", "intensity", "film", "blur"]));
			const sliders = await visible('.setting:visible input[type="range"]');
			if (sliders.length) {
				const slider = pick(sliders);
				await slider.scrollIntoViewIfNeeded();
				await drag(slider);
			}
		}),
		async () => {
			await page.click("#tab-volumes");
			const camera = page.locator(".top-view svg");
			if (await camera.count()) {
				await drag(camera);
			}
		},
		async () => {
			for (const key of ["Control+z", "Control+z", "Control+Shift+Z"]) {
				await page.focus("#canvas");
				await page.keyboard.press(key);
				count();
			}
		},
		async () => {
			await page.click("#pin");
			count();
			const pins = await visible(".pin button:last-child");
			if (pins.length > 2) {
				await pins[0].click();
				count();
			}
		},
		async () => {
			await page.evaluate(() => (document.querySelector("#probe-fold").open = true));
			await page.click("#canvas", { position: { x: 20 + 300 * random(), y: 20 + 150 * random() } });
			count();
		},
		async () => {
			await page.click("#tab-passes");
			await page.evaluate(() => (document.querySelector("#graph-fold").open = !document.querySelector("#graph-fold").open));
			count();
		},
		async () => {
			await page.click("#tab-price");
			await page.click("#measure");
			count();
		},
	];
	await pick(acts)();
	await page.waitForTimeout(50);
	await ask(url, "state");
}

let failed = false;
await startBrowser();
for (const config of configs) {
	await withLive(config, [], (url, parent) => onPage(url, async (page) => {
		const random = makeRandom(7);
		const begin = Date.now();
		let [events, early] = [0, 0];
		while (Date.now() < begin + seconds * 1000) {
			await use(page, url, random, () => ++events);
			if (!early && Date.now() > begin + seconds * 100) {
				early = readMemory(parent);
			}
		}
		const late = readMemory(parent);
		failed ||= late > 1.2 * early;
		console.log(`${basename(config)}: ${seconds} s, ${events} events; ${early.toFixed(0)} MB after a tenth of the time, ${late.toFixed(0)} MB at the end: ${(late / early).toFixed(2)} times`);
	}, { allow: /422|503/ }));
}
await stopBrowser();
process.exitCode = failed ? 1 : 0;
