// Firefox without a window, spoken to by its own remote protocol (Marionette), so that the system's Firefox does.
import { execFileSync, spawn } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { connect, createServer } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { setTimeout as sleep } from "node:timers/promises";

const seconds = 60; // until it listens

/** The program; empty where there is none. */
export function findFirefox() {
	for (const name of ["firefox-esr", "firefox"]) {
		try {
			return execFileSync("sh", ["-c", `command -v ${name}`], { encoding: "utf8" }).trim();
		} catch {
			// the next
		}
	}
	return "";
}

/** A free port of this machine. */
function findPort() {
	return new Promise((done) => {
		const server = createServer().listen(0, "127.0.0.1", () => {
			const { port } = server.address();
			server.close(() => done(port));
		});
	});
}

async function listen(port) {
	for (let tries = 0; tries < seconds * 4; ++tries) {
		const socket = await new Promise((done) => {
			const attempt = connect(port, "127.0.0.1", () => done(attempt));
			attempt.on("error", () => done(null));
		});
		if (socket) {
			return socket;
		}
		await sleep(250);
	}
	throw new Error(`Firefox does not listen after ${seconds} s`);
}

/** Calls test with send(command, parameters), then ends the browser. */
export async function withFirefox(program, test) {
	const profile = mkdtempSync(join(tmpdir(), "drydock_firefox_"));
	const port = await findPort();
	writeFileSync(join(profile, "user.js"), `user_pref("marionette.port", ${port});\nuser_pref("app.update.enabled", false);\nuser_pref("network.captive-portal-service.enabled", false);\n`);
	const browser = spawn(program, ["--headless", "--marionette", "--no-remote", "--profile", profile], { stdio: "ignore", env: { ...process.env, HOME: profile } });
	const ended = new Promise((done) => browser.on("exit", done));
	let socket;
	try {
		socket = await listen(port);
		const waiting = new Map();
		let bytes = Buffer.alloc(0);
		socket.on("data", (more) => {
			bytes = Buffer.concat([bytes, more]);
			for (let colon = bytes.indexOf(":"); colon > 0; colon = bytes.indexOf(":")) {
				const length = Number(bytes.subarray(0, colon));
				if (bytes.length < colon + 1 + length) {
					return;
				}
				const message = JSON.parse(bytes.subarray(colon + 1, colon + 1 + length));
				bytes = bytes.subarray(colon + 1 + length);
				if (Array.isArray(message)) { // the first one is a greeting
					const [, id, error, result] = message;
					const { done, fail } = waiting.get(id);
					error ? fail(new Error(error.message)) : done(result);
				}
			}
		});
		let count = 0;
		const send = (command, parameters = {}) => new Promise((done, fail) => {
			const text = JSON.stringify([0, ++count, command, parameters]);
			waiting.set(count, { done, fail });
			socket.write(`${Buffer.byteLength(text)}:${text}`);
		});
		await send("WebDriver:NewSession", { capabilities: { alwaysMatch: {} } });
		await test(send);
	} finally {
		socket?.destroy();
		browser.kill();
		await ended;
		rmSync(profile, { recursive: true, force: true });
	}
}
