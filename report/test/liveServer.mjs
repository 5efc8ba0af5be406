// Starts `drydock live` for a test and ends it, and reads pictures that drydock wrote.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { readFileSync } from "node:fs";
import { inflateSync } from "node:zlib";

/** The program and its sources, from RunBrowserTests.sh. */
export const drydock = process.env.DRYDOCK;
export const source = process.env.SOURCE;

/** Calls test with the address of a server of the config and the number of its process; it must end cleanly after the test. */
export async function withLive(config, more, test) {
	const server = spawn(drydock, ["live", config, "--no-open", ...more], { stdio: ["ignore", "pipe", "inherit"] });
	const ended = new Promise((done) => server.on("exit", (code, signal) => done(signal ?? code)));
	try {
		let said = "";
		const url = await new Promise((done, fail) => {
			server.stdout.on("data", (text) => {
				said += text;
				const address = /http:\/\/\S+token=\S+/.exec(said);
				address && done(address[0]);
			});
			ended.then((code) => fail(new Error(`drydock live ended with ${code}: ${said}`)));
		});
		await test(url, server.pid);
		await ask(url, "end", {});
		assert.equal(await ended, 0);
	} finally {
		server.kill();
	}
}

/** An answer of the server. */
export async function ask(url, path, body) {
	const token = new URL(url).searchParams.get("token");
	const answer = await fetch(new URL("/api/" + path, url), {
		method: body ? "POST" : "GET", headers: { "X-Drydock-Token": token, "Content-Type": "application/json" }, body: body && JSON.stringify(body),
	});
	assert.ok(answer.ok, `${path}: ${answer.status}`);
	return answer;
}

/** The bytes of a PNG of eight bits, as RGBA. */
export function readPng(file) {
	const data = readFileSync(file);
	const packed = [];
	let [width, height, channels] = [0, 0, 3];
	for (let at = 8; at < data.length; at += 12 + data.readUInt32BE(at)) {
		const chunk = data.subarray(at + 8, at + 8 + data.readUInt32BE(at));
		const type = data.toString("latin1", at + 4, at + 8);
		if (type === "IHDR") {
			assert.ok(chunk[8] === 8 && (chunk[9] === 2 || chunk[9] === 6) && chunk[12] === 0);
			[width, height, channels] = [chunk.readUInt32BE(0), chunk.readUInt32BE(4), chunk[9] === 6 ? 4 : 3];
		} else if (type === "IDAT") {
			packed.push(chunk);
		}
	}
	const raw = inflateSync(Buffer.concat(packed));
	const step = width * channels;
	const lines = new Uint8Array(step * height);
	for (let y = 0, at = 0; y < height; ++y) {
		for (let x = 0; x < step; ++x, ++at) {
			const left = x >= channels ? lines[at - channels] : 0;
			const above = y ? lines[at - step] : 0;
			const corner = x >= channels && y ? lines[at - step - channels] : 0;
			const [toLeft, toAbove, toCorner] = [Math.abs(above - corner), Math.abs(left - corner), Math.abs(left + above - 2 * corner)];
			const guess = [0, left, above, (left + above) >> 1, toLeft <= toAbove && toLeft <= toCorner ? left : toAbove <= toCorner ? above : corner];
			lines[at] = raw[y * (step + 1) + 1 + x] + guess[raw[y * (step + 1)]];
		}
	}
	const bytes = new Uint8Array(width * height * 4).fill(255);
	for (let pixel = 0; pixel < width * height; ++pixel) {
		bytes.set(lines.subarray(pixel * channels, pixel * channels + channels), pixel * 4);
	}
	return { width, height, bytes };
}

/** The picture that the page's canvas holds at one to one, all of it, in base64; as a function of the page. */
export function readShown([width, height]) {
	const canvas = document.querySelector("#canvas");
	const [left, top] = [Math.round((canvas.width - width) / 2), Math.round((canvas.height - height) / 2)];
	if (left < 0 || top < 0) {
		throw new Error(`the canvas of ${canvas.width} x ${canvas.height} is too small`);
	}
	const copy = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true });
	copy.drawImage(canvas, -left, -top);
	const { data } = copy.getImageData(0, 0, width, height);
	let text = "";
	for (let at = 0; at < data.length; at += 30000) {
		text += String.fromCharCode(...data.subarray(at, at + 30000));
	}
	return btoa(text);
}

/** The largest difference of two pictures in each of eight rows of sixteen fields. */
export function mapDifference(a, b) {
	const fields = Array.from({ length: 8 }, () => Array(16).fill(0));
	for (let i = 0; i < a.bytes.length; ++i) {
		const pixel = i >> 2;
		const row = fields[Math.floor((Math.floor(pixel / a.width) * 8) / a.height)];
		const column = Math.floor(((pixel % a.width) * 16) / a.width);
		row[column] = Math.max(row[column], Math.abs(a.bytes[i] - b.bytes[i]));
	}
	return fields;
}
