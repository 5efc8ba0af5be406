// Prints what opening a page costs the browser's main thread: node report/test/open_time.mjs PAGE. CHROMIUM names the
// browser. CPU time, so that other work of the machine counts little; median of seven.
import { resolve } from "node:path";
import { chromium } from "playwright-core";
import { until } from "./harness.mjs";

const browser = await chromium.launch({ executablePath: process.env.CHROMIUM, args: ["--no-sandbox"] });
const milliseconds = [];
for (let run = 0; run < 7; ++run) {
	const page = await browser.newPage();
	const session = await page.context().newCDPSession(page);
	await session.send("Performance.enable", { timeDomain: "threadTicks" });
	await page.goto("file://" + resolve(process.argv[2]));
	await until(page, () => !!document.querySelector("#facts dd"));
	const { metrics } = await session.send("Performance.getMetrics");
	milliseconds.push(1000 * metrics.find((metric) => metric.name === "TaskDuration").value);
	await page.close();
}
await browser.close();
console.log(`main thread ${milliseconds.sort((a, b) => a - b)[3].toFixed(0)} ms until the picture stands`);
