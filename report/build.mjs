// Bundles src/ into page.html: styles, script and a place for the data, one file. `npm run build`; with --check it only
// says whether page.html is what the sources give.
import { build } from "esbuild";
import { readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const folder = dirname(fileURLToPath(import.meta.url));
const read = (path) => readFileSync(join(folder, path), "utf8");

const does = { "@dagrejs/dagre": "layout of the graph", "@dagrejs/graphlib": "graphs, for dagre", fflate: "inflates values" };

async function bundle(parts) {
	const result = await build({
		absWorkingDir: folder, entryPoints: ["src/main.ts"], bundle: true, minify: true, write: false, metafile: true,
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

const parts = weigh((await bundle([])).inputs);
const licenses = parts.filter((part) => does[part.name]).map(({ name, version }) => `${name} ${version}\n${read(`node_modules/${name}/LICENSE`)}`);
const { script } = await bundle(parts);
const style = (await build({
	absWorkingDir: folder, entryPoints: ["src/style.css"],
	minify: true, write: false, charset: "utf8",
})).outputFiles[0].text;

const page = read("src/page.html")
	.replace("/* LICENSES */", () => "\n" + licenses.join("\n\n").replaceAll("--", "- -") + "\n")
	.replace("/* STYLE */", () => style)
	.replace("/* SCRIPT */", () => script.replaceAll("</script", "<\\/script"));

if (process.argv.includes("--check")) {
	if (page !== read("page.html")) {
		console.error("report/page.html is not what report/src gives: npm run build in report/");
		process.exit(1);
	}
} else {
	writeFileSync(join(folder, "page.html"), page);
	console.log(`page.html: ${page.length} characters; ` + parts.map((part) => `${part.name} ${part.bytes}`).join(", "));
}
