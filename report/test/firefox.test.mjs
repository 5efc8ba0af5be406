// Every kind of page opens from disk in Firefox, draws its picture or chart, and answers to a key.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { test } from "node:test";
import { setTimeout as sleep } from "node:timers/promises";
import { withFirefox } from "./firefox.mjs";
import { runs } from "./harness.mjs";

function findFirefox() {
	for (const name of ["firefox-esr", "firefox"]) {
		try {
			return execFileSync("sh", ["-c", `command -v ${name}`], { encoding: "utf8" }).trim();
		} catch {
			// the next
		}
	}
	return "";
}

const program = findFirefox();
const pages = { run: "plain/report.html", study: "study/study.html", diff: "diff/diff.html", sequence: "walk/sequence.html", matrix: "matrix/matrix.html" };

test("all pages draw themselves in Firefox", { skip: program ? false : "there is no Firefox: apt-get install firefox-esr" }, async () => {
	await withFirefox(program, async (send) => {
		const ask = async (script) => (await send("WebDriver:ExecuteScript", { script, args: [] })).value;
		for (const [kind, file] of Object.entries(pages)) {
			await send("WebDriver:Navigate", { url: `file://${runs}/${file}` });
			const isDrawn = kind === "study" ? "return document.querySelectorAll('.point').length > 1"
				: "const canvas = document.querySelector('#canvas'); return !!document.querySelector('#facts dd') && canvas.width > 300 && new Set(canvas.getContext('2d').getImageData(0, canvas.height / 2, canvas.width, 1).data).size > 20";
			for (let tries = 0; tries < 100 && !(await ask(isDrawn)); ++tries) {
				await sleep(100);
			}
			assert.ok(await ask(isDrawn), kind);
			assert.equal(await ask("return document.documentElement.dataset.ready"), "true");
			const theme = await ask("return document.documentElement.dataset.theme ?? ''");
			await send("WebDriver:PerformActions", { actions: [{ type: "key", id: "key", actions: [{ type: "keyDown", value: "t" }, { type: "keyUp", value: "t" }] }] });
			assert.notEqual(await ask("return document.documentElement.dataset.theme ?? ''"), theme, kind);
		}
	});
});
