// Every kind of page opens from disk in Firefox, draws its picture or chart, answers to a key, and fits a desk and a phone.
import assert from "node:assert/strict";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { setTimeout as sleep } from "node:timers/promises";
import { findFirefox, withFirefox } from "./firefox.mjs";
import { axeSource, findSideways, runs } from "./harness.mjs";

const program = findFirefox();
const pages = { run: "plain/report.html", study: "study/study.html", diff: "diff/diff.html", sequence: "walk/sequence.html", matrix: "matrix/matrix.html" };

test("all pages draw themselves in Firefox, on a desk and on a phone", { skip: program ? false : "there is no Firefox: apt-get install firefox-esr" }, async () => {
	const folder = mkdtempSync(join(tmpdir(), "drydock_frames_"));
	await withFirefox(program, async (send) => {
		const ask = async (script) => (await send("WebDriver:ExecuteScript", { script, args: [] })).value;
		const press = (value) => send("WebDriver:PerformActions", { actions: [{ type: "key", id: "key", actions: [{ type: "keyDown", value }, { type: "keyUp", value }] }] });
		await send("WebDriver:SetWindowRect", { width: 1500, height: 1100 });
		for (const [kind, file] of Object.entries(pages)) {
			for (const [width, height] of [[1440, 900], [390, 844]]) {
				const frame = join(folder, `${kind}.${width}.html`); // a window itself does not become as narrow as a phone
				writeFileSync(frame, `<!doctype html><iframe width="${width}" height="${height}" frameborder="0" src="file://${runs}/${file}"></iframe>`);
				await send("WebDriver:Navigate", { url: "file://" + frame });
				await send("WebDriver:SwitchToFrame", { id: 0, focus: true });
				await ask("window.focus()");
				const isDrawn = kind === "study" ? "return document.querySelectorAll('.point').length > 1"
					: "const canvas = document.querySelector('#canvas'); return !!document.querySelector('#facts dd') && canvas.width > 300 && new Set(canvas.getContext('2d').getImageData(0, canvas.height / 2, canvas.width, 1).data).size > 20";
				for (let tries = 0; tries < 100 && !(await ask(isDrawn)); ++tries) {
					await sleep(100);
				}
				assert.ok(await ask(isDrawn), `${kind} at ${width}`);
				assert.equal(await ask("return document.documentElement.dataset.ready"), "true");
				const themes = new Set();
				for (let turn = 0; turn < 2; ++turn) {
					await press("t");
					themes.add(await ask("return getComputedStyle(document.body).backgroundColor"));
					assert.deepEqual(await ask(`return (${findSideways})()`), [], `${kind} at ${width}`);
					const { value: serious } = await send("WebDriver:ExecuteAsyncScript", { args: [], script: `${axeSource}
						const done = arguments[0];
						axe.run(document, { resultTypes: ["violations"] }).then(({ violations }) => done(violations
							.filter(({ impact }) => ["serious", "critical"].includes(impact)).map(({ id, nodes }) => id + ": " + nodes.map((node) => node.target).slice(0, 3))), (error) => done([String(error)]));` });
					assert.deepEqual(serious, [], `${kind} at ${width}`);
				}
				assert.equal(themes.size, 2);
			}
		}
	}).finally(() => rmSync(folder, { recursive: true }));
});
