// The rest of the page in a browser: answers, graph, tables, dialogs, light and dark, and what assistive tools find.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { homedir } from "node:os";
import { after, before, test } from "node:test";
import { deflateSync } from "node:zlib";
import { checkAxe, onPage, readData, runs, startBrowser, stopBrowser, until, withData } from "./harness.mjs";

const plain = runs + "/plain/report.html";
const data = readData(plain);
const shown = data.graph.passes.filter((pass) => data.run.passes.some((other) => other.index === pass.index));
const culled = shown.find((pass) => pass.culled);

before(startBrowser);
after(stopBrowser);

test("five questions are answered, in order, from the run's own files", async () => {
	const run = JSON.parse(readFileSync(runs + "/plain/run.json", "utf8"));
	await onPage(plain, async (page) => {
		const questions = await page.locator("#answers .question").allTextContents();
		assert.deepEqual(questions, ["Did it work?", "What was left out?", "What is not finite?", "Where did the time go?", "What changed?"]);
		assert.match(await page.textContent("#answer-worked"), new RegExp(`${run.passes.filter((pass) => pass.executed).length} passes made a picture of 960 × 540`));
		assert.match(await page.textContent("#answer-left-out"), new RegExp(`${run.effects.filter((effect) => !effect.active).length} of ${run.effects.length} effects`));
		assert.match(await page.textContent("#answer-left-out"), new RegExp(`${run.passes.filter((pass) => !pass.executed).length} passes were culled`));
		await until(page, () => /pixels differ/.test(document.querySelector("#answer-changed").textContent));
		assert.match(await page.textContent("#answer-changed"), /BloomIntensity: 1\.5 → 3/);
	});
});

test("a run without an earlier one, and one with warnings, say so", async () => {
	const other = structuredClone(data);
	delete other.previous;
	other.pictures = other.pictures.filter((picture) => picture.role !== "previous");
	other.run.warnings = [
		{ severity: "warning", code: "DD4001", message: "BloomSetup </script> is strange", where: "configs/x.json:3:4" },
		{ severity: "note", code: "DD4004", message: "it changed nothing", where: "" },
	];
	await withData(other, (file) => onPage(file, async (page) => {
		assert.match(await page.textContent("#answer-changed"), /no earlier run/);
		assert.match(await page.textContent("#answer-worked"), /with 1 warning and 1 note.*BloomSetup <\/script> is strange/s);
		assert.ok(await page.isDisabled("#mode-b"));
		await page.click("#messages .link");
		assert.match(await page.textContent("#pass-detail h3"), /BloomSetup/);
	}));
});

test("packed data are unpacked, and thumbnails that were left out counted", async () => {
	const packed = deflateSync(JSON.stringify({ ...data, thumbnailsLeftOut: 7 })).toString("base64");
	await withData(packed, (file) => onPage(file, async (page) => {
		assert.match(await page.textContent("#picture"), /7 thumbnails of passes were left out/);
	}));
});

test("a culled pass says why, to the mouse, to the keyboard and when opened", async () => {
	await onPage(plain, async (page) => {
		await page.hover(`.order .pass[data-pass="${culled.index}"] text`);
		assert.match(await page.textContent("#tip"), /is culled: /);
		assert.ok((await page.textContent("#tip")).endsWith(culled.reason));
		await page.mouse.move(2, 2);
		await page.focus(`.order .pass[data-pass="${culled.index - 1}"]`);
		await page.keyboard.press("ArrowDown");
		assert.ok(await page.locator("#tip").isVisible());
		assert.ok((await page.textContent("#tip")).endsWith(culled.reason));
		await page.keyboard.press("Enter");
		assert.ok((await page.textContent("#pass-detail .why")).endsWith(culled.reason));
		await page.keyboard.press("Escape");
		assert.equal(await page.locator("#pass-detail").count(), 0);
	});
});

test("an opened pass shows shader, counters, parameters, pictures, and leads to its neighbours", async () => {
	const pass = shown.find((pass) => pass.name.startsWith("BloomSetup"));
	const detail = data.passes.find((other) => other.index === pass.index);
	await onPage(plain, async (page) => {
		await page.click(`.order .pass[data-pass="${pass.index}"] text`);
		const text = await page.textContent("#pass-detail");
		assert.ok(text.includes(pass.shader) && text.includes(detail.shaderFile));
		for (const { name, value } of detail.parameters) {
			assert.ok(text.includes(name) && text.includes(value), name);
		}
		await page.click("#pass-detail .thumbs button");
		await until(page, (index) => document.querySelector("#picture-a").value.includes(index), String(pass.index));
		await page.locator("#pass-detail .reads .link", { hasText: "←" }).first().click();
		await until(page, (producers) => producers.includes(Number(document.querySelector("#pass-detail h3 .quiet").textContent)), pass.producers);
	});
});

test("search finds passes, shaders and resources; Enter opens the first", async () => {
	await onPage(plain, async (page) => {
		await page.keyboard.press("/");
		await page.keyboard.type("bloomsetup");
		const expected = shown.filter((pass) => [pass.name, pass.shader].join(" ").toLowerCase().includes("bloomsetup") ||
			pass.uses.some((use) => data.graph.resources[use.resource].name.toLowerCase().includes("bloomsetup")));
		assert.ok(expected.length > 1 && expected.length < shown.length);
		assert.equal(await page.textContent("#found"), `${expected.length} of ${shown.length} passes`);
		assert.deepEqual(await page.locator(".order .pass.match").evaluateAll((nodes) => nodes.map((node) => Number(node.dataset.pass))), expected.map((pass) => pass.index));
		await page.keyboard.press("Enter");
		assert.equal(Number(await page.textContent("#pass-detail h3 .quiet")), expected[0].index);
	});
});

test("the graph as it flows has every pass and every dependency", async () => {
	const edges = shown.flatMap((pass) => pass.producers.filter((producer) => shown.some((other) => other.index === producer)));
	await onPage(plain, async (page) => {
		await page.focus("#view-flow");
		await page.keyboard.press("Enter");
		assert.equal(await page.locator(".flow .pass").count(), shown.length);
		assert.equal(await page.locator(".flow .edge").count(), edges.length);
		await page.locator(`.flow .pass[data-pass="${culled.index}"]`).focus();
		await page.keyboard.press("Enter");
		assert.match(await page.textContent("#pass-detail .why"), /is culled/);
		await page.click("#view-order");
		assert.equal(await page.locator(".order .pass").count(), shown.length);
	});
});

test("the heap strip has a block for each resource in the heap", async () => {
	const used = new Set(shown.flatMap((pass) => pass.uses.map((use) => use.resource)));
	const placed = data.graph.resources.filter((resource) => used.has(resource.index) && resource.transient && resource.heapOffset >= 0);
	await onPage(plain, async (page) => {
		assert.ok(placed.length > 3);
		assert.equal(await page.locator(".heap .block").count(), placed.length);
		await page.locator(".heap .block").first().hover();
		assert.match(await page.textContent("#tip"), /lives from/);
	});
});

test("settings tell their story, times lead to their passes", async () => {
	await onPage(plain, async (page) => {
		await page.click("#settings summary >> text=BloomToonIntensity");
		assert.match(await page.textContent("#settings details[open]"), /Base/);
		const longest = [...data.timing.passes].sort((a, b) => b.ms - a.ms)[0];
		await page.locator("#time .link").first().click();
		assert.equal(Number(await page.textContent("#pass-detail h3 .quiet")), longest.index);
		const effects = await page.locator("#effects table").first().locator("tbody tr").count();
		assert.equal(effects, data.run.effects.length);
	});
});

test("light and dark follow the system and the switch", async () => {
	const paper = (page) => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
	let light;
	await onPage(plain, async (page) => {
		light = await paper(page);
		await page.keyboard.press("t");
		assert.notEqual(await paper(page), light);
		await page.click("#theme");
		assert.equal(await paper(page), light);
	});
	await onPage(plain, async (page) => {
		assert.notEqual(await paper(page), light);
		await page.click("#theme");
		assert.equal(await paper(page), light);
	}, { colorScheme: "dark" });
});

test("the boxes of keys and of parts open and close", async () => {
	await onPage(plain, async (page) => {
		await page.keyboard.press("?");
		assert.ok(await page.locator("#keys").isVisible());
		await page.keyboard.press("Escape");
		assert.ok(!(await page.locator("#keys").isVisible()));
		await page.click("#show-about");
		for (const part of ["@dagrejs/dagre", "fflate"]) {
			assert.match(await page.textContent(`#about tr:has-text("${part}")`), /MIT.*kB/);
		}
		await page.click("#about button");
		assert.ok(!(await page.locator("#about").isVisible()));
	});
});

test("a stranger is told what the page is, with the picture beside the five answers in view", async () => {
	await onPage(plain, async (page) => {
		assert.match(await page.textContent(".intro p"), /^This page shows .* drydock, which runs Unreal Engine post-processing on the CPU.*\.$/);
		const box = async (selector) => page.locator(selector).boundingBox();
		const [answers, canvas] = [await box("#answers"), await box("#canvas")];
		assert.ok(answers.x + answers.width < canvas.x && answers.y < canvas.y + canvas.height);
		assert.ok(canvas.y + canvas.height <= 900 && canvas.width > 800, JSON.stringify(canvas));
	}, { viewport: { width: 1440, height: 900 } });
	await onPage(plain, async (page) => {
		const { x, y, width, height } = await page.locator("#canvas").boundingBox();
		assert.ok(x >= 0 && x + width <= 390 && width > 330 && y + height <= 844, "the picture is on a phone's first screen");
	}, { viewport: { width: 390, height: 844 } });
});

test("the grid shows a texture as it was at a pass, and a hollow dot where a shader does not read it", async () => {
	const written = data.pictures.find((picture) => picture.role === "thumbnail");
	const name = (index) => data.graph.resources[index].name;
	const writer = shown.find((pass) => pass.index === written.pass);
	const reader = shown.find((pass) => !pass.culled && pass.index > writer.index && pass.uses.some((use) => use.reads && name(use.resource) === written.resource));
	const cell = async (page, pass, kind) => {
		const column = await page.locator(`.order svg:not(.names) .resource[data-resource="${data.graph.resources.findIndex((one) => one.name === written.resource)}"] .life`).boundingBox();
		const row = await page.locator(`.order .pass[data-pass="${pass.index}"] ${kind}`).first().boundingBox();
		await page.mouse.click(column.x + column.width / 2, row.y + row.height / 2);
	};
	const bound = new Map(data.passes.filter((pass) => pass.bound).map((pass) => [pass.index, pass.bound]));
	const unread = shown.filter((pass) => bound.has(pass.index)).flatMap((pass) => [...new Set(pass.uses.map((use) => use.resource))]
		.filter((resource) => pass.uses.every((use) => use.resource !== resource || (!use.writes && !bound.get(pass.index).includes(use.parameter)))));
	await onPage(plain, async (page) => {
		for (const [pass, said] of [[writer, "which wrote it"], [reader, `written by ${writer.index} `]]) {
			await page.locator(`.order .pass[data-pass="${pass.index}"]`).scrollIntoViewIfNeeded();
			await cell(page, pass, ":is(.read, .write)");
			assert.equal(await page.textContent("#texture-detail h3"), written.resource);
			assert.match(await page.textContent("#texture-detail .why"), new RegExp(`^At pass ${pass.index} .*${said}`));
			assert.equal(await page.getAttribute("#texture-detail img", "src"), "data:image/png;base64," + written.png);
			await page.locator("#texture-detail .plot svg").waitFor();
		}
		await page.click("#texture-detail .look");
		await until(page, (id) => document.querySelector("#picture-a").value === id, written.id);
		assert.ok(unread.length > 0);
		assert.equal(await page.locator(".order .read.unread").count(), unread.length);
		await page.focus(`.order .pass[data-pass="${reader.index}"]`);
		await page.keyboard.press("Enter");
		await page.locator("#pass-detail .reads .link", { hasText: written.resource }).first().focus();
		await page.keyboard.press("Enter");
		assert.equal(await page.textContent("#texture-detail h3"), written.resource);
	});
});

test("the page names no folder of the machine", () => {
	assert.doesNotMatch(JSON.stringify({ ...data, pictures: [] }), new RegExp(`${runs}|${process.cwd()}|${homedir()}/`));
});

test("nothing runs over the side, and every control has a name", async () => {
	await checkAxe(plain, async (page) => page.click(`.order .pass[data-pass="${culled.index}"] text`));
});
