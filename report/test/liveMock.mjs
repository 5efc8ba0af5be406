// Speaks the protocol of `drydock live` with made-up data, for tests of the page's behaviour that a real server would give only
// by chance: slow frames, faults, an end. `node liveMock.mjs` serves it to a browser.
import { readFileSync } from "node:fs";
import { createServer } from "node:http";

const schema = JSON.parse(readFileSync(new URL("../../configs/schema/drydock.schema.json", import.meta.url), "utf8"));
const categories = [["Bloom", "Lens|Bloom"], ["Vignette", "Lens|Image Effects"], ["AutoExposure", "Lens|Exposure"], ["Color", "Color Grading|Global"], ["DepthOfField", "Lens|Depth of Field"], ["MotionBlur", "Rendering Features|Motion Blur"]];
const names = schema.definitions.Settings.properties;

function makeSettings() {
	return Object.entries(names).filter(([name]) => !name.startsWith("bOverride_")).map(([name, { default: value, description, enum: list, minimum, maximum, type }]) => ({
		name, display: name.replace(/^b([A-Z])/, "$1").replaceAll(/([a-z])([A-Z0-9])/g, "$1 $2"),
		category: (categories.find(([start]) => name.startsWith(start)) ?? ["", "Rendering Features|Other"])[1],
		type: /Tint|Color\d?$/.test(name) && Array.isArray(value) ? "color" : type === "integer" ? "int32" : typeof value === "number" ? "float" : "other",
		value: value ?? null, default: value ?? null, start: value ?? null, overridden: false, class: /Mask$/.test(name) ? "Texture" : "", inVolumes: [],
		range: { clampMin: minimum ?? (name === "BloomIntensity" ? 0 : null), clampMax: maximum ?? null, uiMin: name === "BloomIntensity" ? 0 : null, uiMax: name === "BloomIntensity" ? 8 : null },
		enum: list?.filter((one) => typeof one === "string"), unit: "", doc: description ?? "", effect: name.startsWith("Bloom") ? "Bloom" : "",
		unread: /^Bloom|^Vignette|^AutoExposure/.test(name) ? "" : "No active pass reads it: its effect is off.", plugin: name === "BloomToonIntensity" ? "ToonBloom" : "",
	}));
}

/** The config of the session; edits are made to a copy. */
const start = {
	scene: { file: "scenes/mock.exr" },
	volumes: [
		{ name: "Base", bUnbound: true, Priority: -1, BlendWeight: 1, Settings: { BloomIntensity: 1.5 } },
		{ name: "Room", bounds: { type: "box", center: [300, 0, 150], extent: [300, 250, 150] }, Priority: 1, BlendRadius: 100, BlendWeight: 1, Settings: { VignetteIntensity: 0.8 } },
		{ name: "Lamp", bounds: { type: "sphere", center: [-350, 80, 150], radius: 120 }, Priority: 2, BlendRadius: 60, BlendWeight: 0.5, Settings: {} },
	],
	view: { location: [-60, 20, 150] },
	cvars: {}, showFlags: {},
};

function apply(config, edit) {
	const keys = (edit.set ?? edit.remove).slice(1).split("/").map((key) => key.replaceAll("~1", "/").replaceAll("~0", "~"));
	const last = keys.pop();
	const at = keys.reduce((object, key) => (object[key] ??= {}), config);
	edit.set === undefined ? delete at[last] : (at[last] = edit.value);
}

function makePicture(config, width, height) {
	const bloom = config.camera?.Settings?.BloomIntensity ?? config.volumes[0].Settings.BloomIntensity ?? 0.675;
	const toon = config.camera?.Settings?.BloomToonIntensity ?? 0.1;
	const vignette = config.camera?.Settings?.VignetteIntensity ?? 0.4;
	const data = new Float32Array(width * height * 4);
	for (let y = 0; y < height; ++y) {
		for (let x = 0; x < width; ++x) {
			const u = x / width;
			const v = y / height;
			const box = u > 0.6 && u < 0.85 && v > 0.3 && v < 0.7;
			const fade = 1 - vignette * ((u - 0.5) ** 2 + (v - 0.5) ** 2);
			const glow = box ? toon : 0.2 * bloom * Math.exp(-8 * ((u - 0.3) ** 2 + (v - 0.5) ** 2));
			const i = (y * width + x) * 4;
			data[i] = fade * Math.min(u * 0.6 + glow, 1);
			data[i + 1] = fade * Math.min(v * 0.6 + glow, 1);
			data[i + 2] = fade * Math.min(0.35 + glow, 1);
			data[i + 3] = 1;
		}
	}
	const bytes = new Uint8Array(data.length);
	for (let i = 0; i < data.length; ++i) {
		bytes[i] = Math.round(data[i] * 255);
	}
	return { width, height, data, bytes };
}

const pass = (index, name, producers, reads, writes, more = {}) => ({
	index, name, scope: "PostProcessing", flags: "Raster", culled: false, reason: "", shader: "F" + name + "PS", entry: "MainPS", effect: name.startsWith("Bloom") ? "Bloom" : "", owner: "",
	renderPassBegin: index, renderPassEnd: index, mergeReason: "", producers,
	uses: [...reads.map((resource) => ({ resource, parameter: "Input", reads: true, writes: false })), ...writes.map((resource) => ({ resource, parameter: "RenderTargets[0]", reads: false, writes: true }))], ...more,
});

function makeReport(frame, state) {
	const passes = [pass(1, "BloomSetup", [], [0], [1]), pass(2, "BloomBlur", [1], [1], [2]), pass(3, "LensFlare", [], [0], [4, 5, 6, 7], { culled: true, reason: "LensFlareIntensity is 0" }), pass(4, "Tonemap", [2], [0, 2], [3])];
	const resource = (index, name, external) => ({ index, name, kind: "texture", shape: "960x540 PF_FloatRGBA", bytes: 4147200, external, extracted: false, transient: !external, firstPass: index || 1, lastPass: 4, heapOffset: external ? -1 : 4147200 * index, reason: "" });
	return {
		format: "drydock-report", formatVersion: 1, kind: "run", name: state.name, written: "2026-01-01T00:00:00Z",
		run: { version: "0", config: state.config, engine: "5.4", precision: "float", storage: "half", scene: { file: "mock.exr", extent: [960, 540], viewRect: [0, 0, 960, 540] }, exposure: { scale: 1 }, settings: {}, effects: frame.effects, extensionCalls: [],
			passes: passes.map(({ index, name, culled, shader }) => ({ index, name, executed: !culled, reason: "", shader, entry: "MainPS", runsAs: "native kernel", pixels: 518400, taps: 2592000, bytesRead: 4147200, bytesWritten: 4147200 })), memory: {}, channels: [], warnings: [] },
		timing: { threads: 2, cpu: "mock", passes: frame.passes, startMs: 0, setupMs: 1, loadMs: 1, compileMs: 1, executeMs: 5, reportMs: 0, saveMs: 0, wallMs: 8 },
		graph: { name: "mock", passes, resources: [resource(0, "SceneColor", true), resource(1, "BloomSetup"), resource(2, "BloomBlur"), resource(3, "Final"), ...["Flare", "Ghosts", "Halo", "Exposure"].map((name, i) => resource(4 + i, name))], memory: { transientPeakBytes: 4147200 * 5, withoutAliasingBytes: 4147200 * 6 } },
		passes: passes.map(({ index }) => ({ index, shaderFile: "/Engine/Private/Mock.usf", parameters: [{ name: "Scale", type: "float", value: "1" }] })),
		settings: [], nonFinite: { passes: [] }, pictures: [["BloomSetup", 1], ["BloomBlur", 2]].map(([resource, of]) => ({
			id: `thumbnail.${of}`, role: "thumbnail", label: resource, pass: of, resource, mip: 0, extent: [1, 1], corner: [0, 0], size: [1, 1], channels: ["R", "G", "B"], encoding: "compressed",
			png: "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==",
		})), thumbnailsLeftOut: 0,
	};
}

/** Starts the mock; delay: ms of a frame; ready: only with its first frame. Gives its address, what the page asked of it, and hands to make it fail or end. */
export async function startMock({ port = 0, delay = 15, width = 480, height = 270, ready = true } = {}) {
	const token = "mock-token";
	const clients = new Set();
	const log = [];
	let fault = null;
	let [revision, config, undone, done] = [1, structuredClone(start), [], []];
	let [running, waiting, lastDrag] = [false, false, undefined];
	const pins = new Map();
	let [pinned, dots, saved] = [0, [], new Set()];
	const pictures = new Map([["start", makePicture(start, width, height)]]);
	const settings = makeSettings();
	let frame = null;

	const tell = (name, data) => clients.forEach((client) => client.write(`event: ${name}\ndata: ${JSON.stringify(data)}\n\n`));
	const makeFrame = (of) => ({
		revision: of, width, height, milliseconds: { passes: delay * 0.8, setup: 1, whole: delay }, passesRun: 2, passesReused: 1,
		passes: [{ index: 1, name: "BloomSetup", ms: 1.2, reused: true }, { index: 2, name: "BloomBlur", ms: 3.4, reused: false }, { index: 4, name: "Tonemap", ms: 1.9, reused: false }],
		messages: [], effects: [{ name: "Bloom", active: true, reason: "BloomIntensity is above 0" }, { name: "LensFlares", active: false, reason: "LensFlareIntensity is 0" }],
	});
	const run = () => {
		if (running) {
			waiting = true;
			return;
		}
		running = true;
		const [of, from] = [revision, structuredClone(config)];
		setTimeout(() => {
			running = false;
			if (fault) {
				tell("fault", { revision: of, messages: fault });
			} else {
				const picture = makePicture(from, width, height);
				pictures.set(String(of), picture).set("now", picture);
				frame = makeFrame(of);
				log.push({ path: "(frame)", body: {} });
				tell("frame", frame);
			}
			if (waiting) {
				waiting = false;
				run();
			}
		}, delay);
	};
	const change = (next) => {
		config = next;
		++revision;
		tell("state", { revision });
		run();
		return { revision };
	};
	const readSetting = (setting) => {
		const own = config.camera?.Settings?.[setting.name];
		const holders = config.volumes.filter((volume) => volume.Settings?.[setting.name] !== undefined);
		const value = own ?? holders.at(-1)?.Settings[setting.name] ?? setting.default;
		return { ...setting, value, start: start.volumes.findLast((volume) => volume.Settings[setting.name] !== undefined)?.Settings[setting.name] ?? setting.default, overridden: own !== undefined, inVolumes: holders.map(({ name }) => name) };
	};
	const weigh = (volume) => {
		const [x, y] = config.view.location;
		const { bounds } = volume;
		const distance = !bounds ? 0 : bounds.type === "sphere" ? Math.max(Math.hypot(x - bounds.center[0], y - bounds.center[1]) - bounds.radius, 0)
			: Math.hypot(...[x, y].map((value, i) => Math.max(Math.abs(value - bounds.center[i]) - bounds.extent[i], 0)));
		const weight = volume.bEnabled === false ? 0 : volume.BlendWeight * (volume.bUnbound ? 1 : Math.max(0, 1 - distance / (volume.BlendRadius || 1)));
		return { name: volume.name, priority: volume.Priority, blendWeight: volume.BlendWeight, blendRadius: volume.BlendRadius ?? 100, unbound: !!volume.bUnbound, enabled: volume.bEnabled !== false, bounds: bounds ? { extent: [0, 0, 0], radius: 0, halfHeight: 0, rotation: [0, 0, 0], points: [], ...bounds } : null, distance, weight, skipped: weight ? null : volume.bEnabled === false ? "it is not enabled" : "the camera is too far away" };
	};
	const makeState = () => ({
		revision, name: "mock", config: "configs/mock.json", canUndo: done.length > 0, canRedo: undone.length > 0, changed: done.length > 0,
		settings: settings.map(readSetting), volumes: config.volumes.map(weigh),
		view: { location: config.view.location, rotation: [0, 0, 0], path: [[-135, 10, 145], [-32, -4, 145], [105, -5, 142]] },
		sequence: { frame: Number(config.scene.frames ?? 2), frames: [1, 2, 3, 5] },
		variables: [["r.BloomQuality", 5, true], ["r.Tonemapper.Quality", 5, true], ["r.DOF.Gather.RingCount", 5, false]].map(([name, value, matters]) => ({ name, value: config.cvars[name] ?? value, default: value, setBy: name in config.cvars ? "config" : "constructor", matters, doc: "What it does." })),
		showFlags: [["Bloom", true], ["Vignette", true], ["Grain", false]].map(([name, matters]) => ({ name, value: config.showFlags[name] ?? true, default: true, matters })),
		pins: [...pins].map(([pin, { name, revision }]) => ({ pin, name, revision })), dots, files: ["configs/mock.json"], frame, fault: fault && { revision, messages: fault },
	});

	const refuse = (status, message, code = "DD1010") => ({ status, body: { messages: [{ severity: "error", code, message, where: "" }] } });
	const answer = async (path, query, body) => {
		const step = (from, to) => {
			if (!from.length) {
				return refuse(422, "there is nothing to undo");
			}
			to.push(config);
			lastDrag = undefined;
			return change(from.pop());
		};
		if (path === "state") {
			return makeState();
		} else if (path === "edit" && !body.edits) {
			if (!("reset" in body)) {
				return body.undo ? step(done, undone) : step(undone, done);
			}
			const one = typeof body.reset === "string";
			const next = structuredClone(one ? config : start);
			if (one) {
				const old = body.reset.slice(1).split("/").reduce((object, key) => object?.[key], start);
				apply(next, old === undefined ? { remove: body.reset } : { set: body.reset, value: old });
			}
			done.push(config);
			return change(next);
		} else if (path === "edit") {
			const next = structuredClone(config);
			for (const edit of body.edits) {
				if (edit.set?.endsWith("Intensity") && typeof edit.value !== "number") {
					return refuse(422, `${edit.set} must be a number`);
				}
				if (edit.set?.startsWith("/cvars/") && typeof edit.value !== "number") {
					return refuse(422, `${edit.set.slice(7)} must be a whole number, but is "${edit.value}"`);
				}
				if (edit.set?.endsWith("BloomThreshold") && edit.value > 100) {
					return refuse(422, "BloomThreshold is too large for the mock");
				}
				apply(next, edit);
			}
			if (!body.drag || body.drag !== lastDrag) {
				done.push(config);
			}
			[undone, lastDrag] = [[], body.drag];
			return change(next);
		} else if (path === "pin") {
			pins.set(++pinned, { name: body.name ?? `pin ${pinned}`, revision });
			pictures.set(`pin-${pinned}`, pictures.get("now"));
			return { pin: pinned };
		} else if (path === "unpin") {
			pins.delete(body.pin);
			return {};
		} else if (path === "pictures") {
			return { pictures: ["textures/dirt.png", "lut.png"] };
		} else if (path === "report/now") {
			return makeReport(frame, makeState());
		} else if (path === "ledger") {
			const setting = readSetting(settings.find(({ name }) => name === query.get("setting")));
			return { ledger: { [setting.name]: setting.value === setting.default ? [] : [{ source: setting.overridden ? "camera" : setting.inVolumes.at(-1), kind: "volume", rule: "Lerp", weight: 1, distance: null, before: setting.default, after: setting.value, skipped: null }] } };
		} else if (path === "price") {
			const dot = { milliseconds: 4 + dots.length + 0.3, error: 0.004 / (1 + dots.length), metric: "flip", label: done.length ? `after ${done.length} steps` : "start", revision };
			dots = [...dots, dot];
			return dot;
		} else if (path === "probe" || path === "trace") {
			return { text: `${path} of ${query.get("x")}, ${query.get("y")}\n  BloomSetup  0.25 0.5 0.75\n  Tonemap     0.3 0.6 0.8` };
		} else if (path === "save") {
			if (saved.has(body.path) && !body.again) {
				return refuse(409, "exists");
			}
			saved.add(body.path);
			return { saved: body.path };
		} else if (path === "end") {
			setTimeout(() => tell("bye", {}), 5);
			return {};
		}
		return refuse(404, `there is no ${path}`);
	};

	const server = createServer(async (request, response) => {
		const url = new URL(request.url, "http://x");
		const path = url.pathname.replace(/^\/api\//, "");
		const chunks = [];
		for await (const chunk of request) {
			chunks.push(chunk);
		}
		const body = chunks.length ? JSON.parse(Buffer.concat(chunks).toString()) : {};
		if (url.pathname === "/" && url.searchParams.get("token") === token) {
			response.writeHead(200, { "Content-Type": "text/html; charset=utf-8" }).end(readFileSync(new URL("../live.html", import.meta.url)));
			return;
		}
		log.push({ method: request.method, path, body, at: performance.now() });
		if ((request.headers["x-drydock-token"] ?? url.searchParams.get("token")) !== token) {
			response.writeHead(403).end("{}");
		} else if (chunks.length && request.headers["content-type"] !== "application/json") {
			response.writeHead(415).end("{}");
		} else if (path === "events") {
			response.writeHead(200, { "Content-Type": "text/event-stream", "Cache-Control": "no-store" });
			response.write(": here\n\n");
			clients.add(response);
			response.on("close", () => clients.delete(response));
		} else if (path.startsWith("picture/")) {
			const picture = pictures.get(path.slice(8));
			const kind = url.searchParams.get("kind");
			if (!picture) {
				response.writeHead(404).end("{}");
				return;
			}
			const data = kind === "final8" ? picture.bytes : kind === "pass" ? picture.data.map((value, i) => (i % 4 === 3 ? 1 : value * 4)) : picture.data;
			response.writeHead(200, { "Content-Type": "application/octet-stream", "X-Drydock-Width": width, "X-Drydock-Height": height, "X-Drydock-Channels": "4", "X-Drydock-Type": kind === "final8" ? "uint8" : "float" });
			response.end(Buffer.from(data.buffer, data.byteOffset, data.byteLength));
		} else if (path === "text" || path === "session") {
			response.writeHead(200, { "Content-Type": "text/plain" }).end(url.searchParams.get("as") === "config" ? "// of the mock\n" + JSON.stringify(config) : `${path} ${url.searchParams.get("as") ?? ""}\n`);
		} else {
			const said = await answer(path, url.searchParams, body);
			response.writeHead(said.status ?? 200, { "Content-Type": "application/json" }).end(JSON.stringify(said.body ?? said));
		}
	});
	await new Promise((ready) => server.listen(port, "127.0.0.1", ready));
	run();
	await new Promise((done) => setTimeout(done, ready ? delay + 100 : 0));
	const hands = {
		url: `http://127.0.0.1:${server.address().port}/?token=${token}`, log, pictures,
		fail: (messages) => {
			fault = messages;
			++revision;
			tell("state", { revision });
			run();
		},
		getRevision: () => revision,
		/** As after a crash: it counts anew. */
		restart: () => ([revision, running, waiting] = [1, false, false]) && run(),
		breakOff: () => new Promise((closed) => {
			server.close(closed);
			server.closeAllConnections();
		}),
		reopen: () => new Promise((open) => server.listen(Number(new URL(hands.url).port), "127.0.0.1", open)),
	};
	return hands;
}

if (process.argv[1] === new URL(import.meta.url).pathname) {
	console.log((await startMock({ port: Number(process.argv[2] ?? 0) })).url);
}
