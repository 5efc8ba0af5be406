// The page of a study in a browser: its sentence, its points by mouse and keyboard, two of them pinned.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { checkAxe, onPage, readData, runs, startBrowser, stopBrowser, withData } from "./harness.mjs";

const file = runs + "/study/study.html";
const data = readData(file);
const job = data.timing.jobs[0];
const metric = data.study.metric;

before(startBrowser);
after(stopBrowser);

test("its title says the result, and the recommended point alone has a ring", async () => {
	await onPage(file, async (page) => {
		const title = await page.textContent("#chart-title");
		assert.ok(job.recommended && title.startsWith(job.recommended + " is enough: "), title);
		assert.equal(await page.locator(".ring").count(), 1);
		assert.equal(await page.locator(".point", { has: page.locator(".ring") }).getAttribute("data-variant"), job.recommended);
		assert.equal(await page.locator(".point").count(), data.study.jobs[0].variants.filter((variant) => !variant.excluded).length);
		assert.match(await page.textContent("#variant h3"), /recommended/);
	}, {});
});

test("hover and focus show a variant with its figures and pictures", async () => {
	const shown = data.insets[0].pictures.filter((picture) => picture.heat);
	assert.ok(shown.length > 0);
	await onPage(file, async (page) => {
		for (const variant of data.study.jobs[0].variants) {
			await page.locator(`.point[data-variant="${variant.label}"]`).focus();
			assert.ok((await page.textContent("#variant h3")).startsWith(variant.label));
			const pictures = shown.some((picture) => picture.title === variant.label || picture.title.startsWith(variant.label + " ("));
			assert.equal(await page.locator("#variant img").count(), pictures ? 2 : 0, variant.label);
		}
		await page.hover("#chart-title");
		await page.locator(`.point[data-variant="${job.recommended}"] .dot`).hover();
		assert.ok((await page.textContent("#variant h3")).startsWith(job.recommended));
	});
});

test("two variants are pinned by click and by Enter, and let go again", async () => {
	await onPage(file, async (page) => {
		await page.locator(".point .dot").first().scrollIntoViewIfNeeded();
		// By mouse only what no other point covers: where points lie was measured just now.
		const [first, second] = await page.locator(".point .dot").evaluateAll((dots) => {
			const name = (dot) => dot.closest(".point").dataset.variant;
			const onTop = dots.filter((dot) => {
				const box = dot.getBoundingClientRect();
				return document.elementFromPoint(box.x + box.width / 2, box.y + box.height / 2)?.closest(".point") === dot.closest(".point");
			});
			return [name(onTop[0]), name(dots.find((dot) => name(dot) !== name(onTop[0])))];
		});
		await page.locator(`.point[data-variant="${first}"] .dot`).click({ force: true });
		await page.locator(`.point[data-variant="${second}"]`).focus();
		await page.keyboard.press("Enter");
		assert.deepEqual(await page.locator("#pins .variant h3").evaluateAll((titles) => titles.map((title) => title.firstChild.textContent)), [first, second]);
		assert.match(await page.textContent("#pins .note"), /% of the time/);
		await page.keyboard.press("Enter");
		assert.equal(await page.locator("#pins .variant").count(), 1);
	});
});

test("other errors and costs draw the chart anew", async () => {
	await onPage(file, async (page) => {
		const place = () => page.locator(".study-chart .dot, .study-chart .tick").evaluateAll((marks) => marks.map((mark) => mark.getAttribute("cx") + mark.getAttribute("cy") + mark.textContent).join());
		const seen = new Set([await place()]);
		for (const name of ["rms", "max", "relative", "psnr", "ssim"].filter((name) => name !== metric)) {
			await page.selectOption("#metric", name);
			seen.add(await place());
		}
		assert.equal(seen.size, 5);
		await page.focus("#cost-1");
		await page.keyboard.press("Enter");
		seen.add(await place());
		assert.equal(seen.size, 6);
		await page.click("#variants summary");
		assert.equal(await page.locator("#variants tbody tr").count(), data.study.jobs[0].variants.length);
	});
});

test("small panels show every job, and one of them becomes the chart", async () => {
	const last = data.study.jobs.length - 1;
	assert.ok(last > 0);
	await onPage(file, async (page) => {
		assert.ok(!(await page.locator("#panels").isVisible()));
		await page.click("#show-panels");
		assert.equal(await page.locator(".panel").count(), data.study.jobs.length);
		await page.focus(`[data-panel="${last} ${metric}"]`);
		await page.keyboard.press("Enter");
		assert.equal(await page.getAttribute("#job-" + last, "aria-pressed"), "true");
		assert.ok((await page.textContent("#chart-title")).includes(data.timing.jobs[last].recommended));
		assert.deepEqual(await page.locator('.panel[aria-pressed="true"]').evaluateAll((panels) => panels.map((panel) => panel.dataset.panel)), [`${last} ${metric}`]);
		await page.click("#chart-title");
		await page.keyboard.press("g");
		assert.ok(!(await page.locator("#panels").isVisible()));
	});
});

test("where there is one job, small panels show every error", async () => {
	const one = { ...data, charts: data.charts.slice(0, 1), study: { ...data.study, jobs: data.study.jobs.slice(0, 1) }, timing: { ...data.timing, jobs: data.timing.jobs.slice(0, 1) } };
	await withData(one, (single) => onPage(single, async (page) => {
		await page.keyboard.press("g");
		assert.equal(await page.locator(".panel").count(), 6);
		await page.click('[data-panel="0 ssim"]');
		assert.equal(await page.inputValue("#metric"), "ssim");
		assert.equal(await page.getAttribute('[data-panel="0 ssim"]', "aria-pressed"), "true");
	}));
});

test("many jobs are a list, and panels choose from it, too", async () => {
	const often = (jobs) => Array.from({ length: 8 }, (_, i) => ({ ...jobs[i % 2], label: "job " + i }));
	const many = { ...data, charts: Array.from({ length: 8 }, (_, i) => data.charts[i % 2]), study: { ...data.study, jobs: often(data.study.jobs) }, timing: { ...data.timing, jobs: often(data.timing.jobs) } };
	await withData(many, (file) => onPage(file, async (page) => {
		await page.selectOption("#job", "job 3");
		assert.ok((await page.textContent("#chart-title")).includes(data.timing.jobs[1].recommended));
		await page.click("#chart-title");
		await page.keyboard.press("g");
		await page.click(`[data-panel="6 ${metric}"]`);
		assert.equal(await page.inputValue("#job"), "job 6");
	}));
});

test("nothing runs over the side, and axe finds nothing serious, in light and dark", async () => {
	await checkAxe(file, async (page) => page.click("#show-panels"));
});
