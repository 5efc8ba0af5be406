// Bundles src/ into page.html: styles, script and a place for the data, one file; and src/live/ into live.html, the page
// of `drydock live`. `npm run build`; with --check it only says whether the files are what the sources give.
import { build } from "esbuild";
import { readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const folder = dirname(fileURLToPath(import.meta.url));
const read = (path) => readFileSync(join(folder, path), "utf8");

const does = { "@dagrejs/dagre": "layout of the graph", "@dagrejs/graphlib": "graphs, for dagre", fflate: "inflates values" };

async function bundle(entry, parts) {
	const result = await build({
		absWorkingDir: folder, entryPoints: [entry], bundle: true, minify: true, write: false, metafile: true,
		format: "iife", target: "es2022", charset: "utf8", legalComments: "none",
		define: { PARTS: JSON.stringify(parts) }, outfile: "page.js",
	});
	const [metafile] = Object.values(result.metafile.outputs);
	return { script: result.outputFiles[0].text, inputs: metafile.inputs };
}

/** What of the bundle is whose. */
function weigh(inputs) {
	const weights = new Map();
	for (const [path, { bytesInOutput }] of Object.entries(inputs)) {
		const name = /node_modules\/((?:@[^/]+\/)?[^/]+)/.exec(path)?.[1] ?? "drydock";
		weights.set(name, (weights.get(name) ?? 0) + bytesInOutput);
	}
	return [...weights].map(([name, bytes]) => {
		const manifest = name === "drydock" ? null : JSON.parse(read(`node_modules/${name}/package.json`));
		return { name, version: manifest?.version ?? "", license: manifest?.license ?? "as drydock", does: does[name] ?? "the page", bytes };
	}).sort((a, b) => b.bytes - a.bytes);
}

async function makePage(entry, styles) {
	const parts = weigh((await bundle(entry, [])).inputs);
	const licenses = parts.filter((part) => does[part.name]).map(({ name, version }) => `${name} ${version}\n${read(`node_modules/${name}/LICENSE`)}`);
	const { script } = await bundle(entry, parts);
	const style = (await build({
		stdin: { contents: styles.map((path) => `@import "./${path}";`).join(""), resolveDir: folder, loader: "css" },
		bundle: true, minify: true, write: false, charset: "utf8",
	})).outputFiles[0].text;
	const page = read("src/page.html")
		.replace("/* LICENSES */", () => "\n" + licenses.join("\n\n").replaceAll("--", "- -") + "\n")
		.replace("/* STYLE */", () => style)
		.replace("/* SCRIPT */", () => script.replaceAll("</script", "<\\/script"));
	return { page, parts };
}

const live = await makePage("src/live/main.ts", ["src/style.css", "src/live/live.css"]);
live.page = live.page.replace("script-src 'unsafe-inline'", "script-src 'unsafe-inline'; connect-src 'self'")
	.replace("; its data are in the element #data", "").replace(/<script type="application\/json".*\n/, "");
const pages = { "page.html": await makePage("src/main.ts", ["src/style.css"]), "live.html": live };

for (const [name, { page, parts }] of Object.entries(pages)) {
	if (!process.argv.includes("--check")) {
		writeFileSync(join(folder, name), page);
		console.log(`${name}: ${page.length} characters; ` + parts.map((part) => `${part.name} ${part.bytes}`).join(", "));
	} else if (page !== read(name)) {
		console.error(`report/${name} is not what report/src gives: npm run build in report/`);
		process.exitCode = 1;
	}
}
