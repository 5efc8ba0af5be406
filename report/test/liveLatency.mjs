// From the hand to the drawn picture in Chromium, as the page of `drydock live` measures it, while a slider is dragged. Beside
// it stands what is left without the passes of the same frame. Prints a table in Markdown. The browser is driven by its pipe:
// a tool that watches requests, as the tests' one does, makes each of them slower.
//
//     CHROMIUM=/usr/bin/chromium DRYDOCK=build/release/bin/drydock SOURCE=$PWD node report/test/liveLatency.mjs [PICTURES]
import { spawn } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { setTimeout as sleep } from "node:timers/promises";
import { source, withLive } from "./liveServer.mjs";

const wanted = Number(process.argv[2] ?? 200);
const warm = 10; // pictures that are not counted
const folder = mkdtempSync(join(tmpdir(), "drydock_latency_"));
const browser = spawn(process.env.CHROMIUM, ["--headless", "--no-sandbox", "--remote-debugging-pipe", `--user-data-dir=${folder}`, "--window-size=1440,900"], { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });

const answers = new Map();
let [number, text] = [0, ""];
browser.stdio[4].on("data", (data) => {
	const messages = (text + data).split("\0");
	text = messages.pop();
	messages.map((message) => JSON.parse(message)).forEach(({ id, result, error }) => answers.get(id)?.(result ?? Promise.reject(new Error(error?.message))));
});

/** Calls a method of the browser's protocol. */
function call(method, params = {}, sessionId = undefined) {
	browser.stdio[3].write(JSON.stringify({ id: ++number, method, params, sessionId }) + "\0");
	return new Promise((done) => answers.set(number, done));
}

/** Opens a page; its functions: ask evaluates an expression, mouse sends an event of the mouse. */
async function openPage(url) {
	const { targetId } = await call("Target.createTarget", { url });
	const { sessionId } = await call("Target.attachToTarget", { targetId, flatten: true });
	await call("Emulation.setDeviceMetricsOverride", { width: 1440, height: 900, deviceScaleFactor: 1, mobile: false }, sessionId);
	const ask = async (expression) => (await call("Runtime.evaluate", { expression, returnByValue: true, awaitPromise: true }, sessionId)).result.value;
	const mouse = (type, x, y, buttons = 1) => call("Input.dispatchMouseEvent", { type, x, y, button: "left", buttons, clickCount: 1 }, sessionId);
	return { ask, mouse, close: () => call("Target.closeTarget", { targetId }) };
}

/** Drags a slider to and fro until so many pictures came; each: ms, and ms without its passes. */
async function measureDrag({ ask, mouse }, setting) {
	while (!(await ask("document.documentElement.dataset.ready === 'true' && !!document.querySelector('#facts dd')"))) {
		await sleep(100);
	}
	const [x, y, width] = await ask(`(() => {
		window.waits = [];
		const latency = document.querySelector("#latency");
		new MutationObserver(() => waits.push([Number(latency.dataset.ms), Number(latency.dataset.beside)])).observe(latency, { attributeFilter: ["data-ms"] });
		const search = document.querySelector("#settings-search");
		search.value = "${setting}";
		search.dispatchEvent(new Event("input"));
		const box = document.querySelector("#set-${setting}").getBoundingClientRect();
		return [box.x, box.y + box.height / 2, box.width];
	})()`);
	await sleep(1000);
	await mouse("mouseMoved", x + width / 2, y, 0);
	await mouse("mousePressed", x + width / 2, y);
	for (let step = 0; (await ask("waits.length")) < wanted + warm; ++step) {
		await mouse("mouseMoved", x + width * (0.5 + 0.3 * Math.sin(step / 40)), y);
		await sleep(12);
	}
	await mouse("mouseReleased", x + width / 2, y);
	return (await ask("waits")).slice(warm);
}

/** The value that this part of a list does not exceed. */
const getPart = (values, part) => values.toSorted((a, b) => a - b)[Math.floor((values.length - 1) * part)];

try {
	console.log("| frame | dragged | hand to picture, median ms | 95th percentile | beside the passes, median ms | 95th percentile |");
	console.log("|---|---|--:|--:|--:|--:|");
	for (const [size, scene] of [["960 x 540", "toon_character"], ["1920 x 1080", "toon_character_1080p"]]) {
		const config = join(folder, scene + ".json");
		writeFileSync(config, JSON.stringify({ scene: { file: `${source}/configs/scenes/${scene}.exr` }, volumes: [{ bUnbound: true, Settings: { BloomIntensity: 1.5, BloomToonIntensity: 0.1 } }] }));
		for (const setting of ["BloomToonIntensity", "FilmSlope"]) {
			await withLive(config, [], async (url) => {
				const page = await openPage(url);
				const waits = await measureDrag(page, setting);
				const cells = [0, 1].flatMap((i) => [0.5, 0.95].map((part) => getPart(waits.map((wait) => wait[i]), part).toFixed(1)));
				console.log(`| ${[size, setting, ...cells].join(" | ")} |`);
				await page.close();
			});
		}
	}
} finally {
	browser.kill();
	await new Promise((done) => browser.on("exit", done));
	rmSync(folder, { recursive: true, force: true });
}
