// Speaks with `drydock live`: requests with the token, its events, and edits of which one at most is in flight.
import { Pixels, fromBytes } from "../picture/pixels";
import { Edit, Frame, Message } from "./data";

/** An answer of the server that is not the one asked for. */
export class Refusal extends Error {
	constructor(readonly status: number, readonly messages: Message[]) {
		super(messages.map((message) => message.message).join("; "));
	}
}

/** It stays in the address, so that a reload has it; the page has no links that could carry it elsewhere. */
const token = new URLSearchParams(location.search).get("token") ?? "";

async function send(path: string, method: string, body?: unknown): Promise<Response> {
	let answer: Response;
	try {
		answer = await fetch("/api/" + path, { method, cache: "no-store", headers: { "X-Drydock-Token": token, "Content-Type": "application/json" }, body: body === undefined ? undefined : JSON.stringify(body) });
	} catch {
		throw new Refusal(0, [{ severity: "error", code: "", message: "drydock live does not answer", where: "" }]);
	}
	if (!answer.ok) {
		const said = await answer.json().catch(() => null) as { messages?: Message[] } | null;
		throw new Refusal(answer.status, said?.messages?.length ? said.messages : [{ severity: "error", code: "", message: `drydock live refused (${answer.status})`, where: path }]);
	}
	return answer;
}

export const getText = async (path: string): Promise<string> => (await send(path, "GET")).text();
export const get = async <T>(path: string): Promise<T> => JSON.parse(await getText(path)) as T;
export const post = async <T>(path: string, body: unknown = {}): Promise<T> => (await send(path, "POST", body)).json() as Promise<T>;

/** The body; where its length is known, into one piece of memory, which takes half the time. */
async function readBytes(answer: Response): Promise<ArrayBuffer> {
	const length = Number(answer.headers.get("Content-Length"));
	if (!length) {
		return answer.arrayBuffer();
	}
	const reader = answer.body!.getReader({ mode: "byob" });
	let body = new ArrayBuffer(length);
	for (let at = 0; at < length; ) {
		const { value, done } = await reader.read(new Uint8Array(body, at));
		if (done) {
			throw new Error("the picture broke off");
		}
		[body, at] = [value.buffer as ArrayBuffer, at + value.length];
	}
	return body;
}

/** A picture as bytes for the display, or as numbers. Step: of the bytes, one for so many texels in a row. */
export async function getPicture(id: string | number, query: string, step = 1): Promise<Pixels> {
	const answer = await send(`picture/${id}?${query}&step=${step}`, "GET");
	const header = (name: string) => answer.headers.get("X-Drydock-" + name) ?? "";
	const [width, height] = [Number(header("Width")), Number(header("Height"))];
	const body = await readBytes(answer);
	if (query === "kind=final8") {
		const pixels = fromBytes(Math.ceil(width / step), Math.ceil(height / step), new Uint8ClampedArray(body));
		return step > 1 ? Object.assign(pixels, { whole: { width, height } }) : pixels;
	}
	const names = header("Channels");
	const channels = /[A-Za-z]/.test(names) ? names.split(",").map((name) => name.trim()) : ["R", "G", "B", "A"].slice(0, Number(names) || 4);
	return { width, height, channels, data: new Float32Array(body), display: query === "kind=final", precision: "float" };
}

export interface Listener {
	state: (revision: number) => void;
	frame: (frame: Frame) => void;
	fault: (revision: number, messages: Message[]) => void;
	bye: () => void;
	gone: () => void; // it does not answer; the page tries again
	back: () => void;
}

export function listen(listener: Listener): void {
	const events = new EventSource("/api/events?token=" + encodeURIComponent(token));
	const on = (name: string, act: (data: any) => void) => events.addEventListener(name, (event) => act(JSON.parse((event as MessageEvent<string>).data || "{}")));
	let ended = false;
	on("state", ({ revision }) => listener.state(revision));
	on("frame", listener.frame);
	on("fault", ({ revision, messages }) => listener.fault(revision, messages));
	on("bye", () => {
		ended = true;
		events.close();
		listener.bye();
	});
	events.onopen = () => listener.back();
	events.onerror = () => {
		if (!ended) {
			listener.gone();
			if (events.readyState === EventSource.CLOSED) { // which the browser does not mend itself
				setTimeout(() => listen(listener), 2000);
			}
		}
	};
}

interface Waiting {
	edits: Map<string, { edit: Edit; refused: (messages: Message[]) => void }>; // by place: the newest
	drag?: string;
	at: number; // of the input, in performance.now()'s time
}

/** Sends edits: while one is in flight the newest of each place waits. */
export class Hand {
	onRevision: (revision: number) => void = () => undefined;
	private waiting: Waiting | null = null;
	private flying = false;
	private awaited = 0; // revision
	private newest = 0; // of this page's edits
	private done = 0; // newest revision that became a frame or a fault
	private readonly inputs: { revision: number; at: number; drag?: string }[] = [];
	private waits: number[] = []; // of the last drag, ms from input to picture
	private dragged: string | undefined;
	private timer = 0;

	get rests(): boolean {
		return !this.flying && !this.waiting;
	}

	/** Whether a state has all that this page changed. */
	knows(revision: number): boolean {
		return this.rests && revision >= this.newest;
	}

	edit(edits: Edit[], refused: (messages: Message[]) => void, drag?: string, at = performance.now()): void {
		this.waiting ??= { edits: new Map(), drag, at };
		Object.assign(this.waiting, { drag, at });
		for (const edit of edits) {
			this.waiting.edits.set("set" in edit ? edit.set : edit.remove, { edit, refused });
		}
		void this.send();
	}

	/** A revision became a frame or a fault. */
	finish(revision: number): void {
		this.done = Math.max(this.done, revision);
		if (this.flying && this.awaited && this.done >= this.awaited) {
			this.land();
		}
	}

	/** The picture of a revision is drawn: ms since the input that made it, and the drag's median; null: it was not this page's. */
	drawn(revision: number): { ms: number; median: number; count: number } | null {
		const input = this.inputs.findLast((one) => one.revision <= revision);
		this.inputs.splice(0, this.inputs.length, ...this.inputs.filter((one) => one.revision > revision));
		if (!input) {
			return null;
		}
		const ms = performance.now() - input.at;
		if (!input.drag || input.drag !== this.dragged) {
			[this.waits, this.dragged] = [[], input.drag];
		}
		const waits = this.waits;
		waits.push(ms);
		return { ms, median: waits.toSorted((a, b) => a - b)[waits.length >> 1], count: waits.length };
	}

	private land(): void {
		clearTimeout(this.timer);
		[this.flying, this.awaited] = [false, 0];
		void this.send();
	}

	private async send(): Promise<void> {
		if (this.flying || !this.waiting) {
			return;
		}
		const { edits, drag, at } = this.waiting;
		[this.flying, this.awaited, this.waiting] = [true, 0, null];
		try {
			const { revision } = await post<{ revision: number }>("edit", { edits: [...edits.values()].map(({ edit }) => edit), ...(drag && { drag }) });
			this.inputs.push({ revision, at, drag });
			this.awaited = this.newest = revision;
			this.onRevision(revision);
			this.timer = window.setTimeout(() => this.land(), 30000); // a frame that never came
			this.finish(this.done);
		} catch (refusal) {
			new Set([...edits.values()].map(({ refused }) => refused)).forEach((refused) => refused((refusal as Refusal).messages ?? []));
			this.land();
		}
	}
}
