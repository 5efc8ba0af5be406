// Runs all browser tests in one process with one browser.
import { readdirSync } from "node:fs";

for (const file of readdirSync(new URL(".", import.meta.url)).filter((name) => name.endsWith(".test.mjs")).sort()) {
	await import("./" + file);
}
