// Prints how long a page takes to open: node report/test/open_time.mjs PAGE. CHROMIUM names the browser. CPU time of its main
// thread, of which other work of the machine takes little, and the time that passes until the picture stands and keys are
// listened to, polled every 20 ms; medians of seven.
import { resolve } from "node:path";
import { chromium } from "playwright-core";
import { until } from "./harness.mjs";

const browser = await chromium.launch({ executablePath: process.env.CHROMIUM, args: ["--no-sandbox"] });
const milliseconds = [];
const passed = [];
for (let run = 0; run < 7; ++run) {
	const page = await browser.newPage();
	const session = await page.context().newCDPSession(page);
	await session.send("Performance.enable", { timeDomain: "threadTicks" });
	const begin = performance.now();
	await page.goto("file://" + resolve(process.argv[2]));
	await until(page, () => !!document.querySelector("#facts dd"));
	passed.push(performance.now() - begin);
	const { metrics } = await session.send("Performance.getMetrics");
	milliseconds.push(1000 * metrics.find((metric) => metric.name === "TaskDuration").value);
	await page.close();
}
await browser.close();
const median = (list) => list.sort((a, b) => a - b)[3].toFixed(0);
console.log(`main thread ${median(milliseconds)} ms, ${median(passed)} ms pass until the picture stands`);
