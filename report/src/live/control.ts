// Makes the control of one value: slider and number, tick, list, colour, vector, or text.
import { el } from "../dom";
import { number } from "../format";
import { linearToSrgb, srgbToLinear } from "../picture/pixels";
import { Json, Message } from "./data";
import { get } from "./server";

export interface ControlOptions {
	id: string;
	label: string;
	type: string; // the server's word for it
	value: Json;
	range?: { clampMin: number | null; clampMax: number | null; uiMin: number | null; uiMax: number | null };
	enum?: string[];
	objectClass?: string; // of a text: Texture, Texture2D, TextureCube or CurveFloat
	guess?: number; // a value beside which a slider without bounds must have room
	send: (value: Json, drag?: string, at?: number) => void;
	refuse: (message: string) => void; // empty: the value is fine
}

export interface Control {
	element: HTMLElement;
	/** Shows a value that came from elsewhere, unless a hand is at the control. */
	show: (value: Json) => void;
}

/** The line under a control with the fault of a value; an empty one goes away. */
export function makeFault(): { element: HTMLElement; say: (text: string) => void; refused: (messages: Message[]) => void } {
	const element = el("p", { class: "refused", role: "alert", hidden: true });
	const say = (text: string) => {
		element.textContent = text;
		element.hidden = !text;
	};
	return { element, say, refused: (messages) => say(messages.map((one) => [one.code, one.message].filter(Boolean).join(": ")).join(" ")) };
}

let drags = 0;

export const startDrag = (): string => `${Math.round(performance.timeOrigin)}-${++drags}`;

/** A round step of which a slider has some two hundred. */
function findStep(low: number, high: number): number {
	const rough = (high - low) / 200;
	const unit = 10 ** Math.floor(Math.log10(rough));
	return unit * [1, 2, 5, 10].find((factor) => factor * unit >= rough * 0.999)!;
}

/** Parses what a person typed: a number, or the sentence with its fault. */
function parse(text: string, options: ControlOptions): number | string {
	const value = text.trim() === "" ? NaN : Number(text);
	const { clampMin: least = null, clampMax: most = null } = options.range ?? {};
	if (!Number.isFinite(value)) {
		return `"${text}" is not a number.` + (/^\s*-?\d+,\d+\s*$/.test(text) ? ` Write ${text.trim().replace(",", ".")}.` : "");
	}
	if ((least !== null && value < least) || (most !== null && value > most)) {
		return `${options.label} goes ${least !== null ? `from ${number(least)}` : ""}${most !== null ? ` to ${number(most)}` : " up"}; ${text.trim()} was not sent.`;
	}
	return /int/.test(options.type) && !Number.isInteger(value) ? `${options.label} is a whole number; ${text.trim()} was not sent.` : value;
}

/** A field whose text is sent when it is left or Enter is pressed. */
function makeField(options: ControlOptions, label: string, css: string, read: (text: string) => string | null): { input: HTMLInputElement; show: (text: string) => void } {
	const input = el<HTMLInputElement>("input", {
		type: "text", class: css, "aria-label": label, spellcheck: "false", autocomplete: "off", inputmode: css === "number-box" ? "decimal" : undefined,
		onchange: () => {
			options.refuse("");
			const fault = read(input.value);
			input.setAttribute("aria-invalid", String(!!fault));
			fault ? options.refuse(fault) : (input.defaultValue = input.value);
		},
		onkeydown: (event: KeyboardEvent) => {
			if (event.key === "Escape" && input.value !== input.defaultValue) {
				event.preventDefault();
				put(input.defaultValue);
				options.refuse("");
			}
		},
	});
	const put = (text: string) => {
		[input.defaultValue, input.value] = [text, text]; // the default: as it was sent or came
		input.setAttribute("aria-invalid", "false");
	};
	const typed = () => (document.activeElement === input && input.value !== input.defaultValue) || input.getAttribute("aria-invalid") === "true";
	return { input, show: (text) => (typed() ? undefined : put(text)) };
}

function makeNumber(options: ControlOptions): Control {
	const { uiMin, uiMax, clampMin, clampMax } = options.range ?? { uiMin: null, uiMax: null, clampMin: null, clampMax: null };
	const span = Math.max(1, ...[options.value, options.guess ?? 0].map((value) => 2 * Math.abs(Number(value))));
	const min = uiMin ?? clampMin ?? (uiMax !== null && uiMax <= 0 ? uiMax - span : Number(options.value) < 0 || Number(options.guess) < 0 ? -span : 0);
	const max = uiMax ?? clampMax ?? Math.max(span, min + span);
	let drag = "";
	const slider = el<HTMLInputElement>("input", {
		type: "range", id: options.id, min, max, step: /int/.test(options.type) ? Math.max(1, findStep(min, max)) : findStep(min, max), "aria-label": options.label,
		oninput: (event: Event) => {
			drag ||= startDrag();
			field.show(number(Number(slider.value)));
			options.refuse("");
			options.send(Number(slider.value), drag, event.timeStamp);
		},
		onchange: () => (drag = ""),
	});
	const field = makeField(options, `${options.label}, number`, "number-box", (text) => {
		const value = parse(text, options);
		if (typeof value === "string") {
			return value;
		}
		slider.value = String(value);
		options.send(value);
		return null;
	});
	return {
		element: el("div", { class: "control" }, slider, field.input),
		show: (value) => {
			if (!drag) {
				slider.value = String(value);
				field.show(typeof value === "number" ? String(Number(value.toPrecision(7))) : String(value));
			}
		},
	};
}

function makeParts(options: ControlOptions, start: number[], colored: boolean): Control {
	let values = start;
	const names = colored ? ["R", "G", "B", "A"] : ["X", "Y", "Z", "W"];
	const change = (i: number, value: number, drag?: string, at?: number) => {
		values = values.with(i, value);
		options.send(values, drag, at);
	};
	const fields = values.map((_, i) => makeField(options, `${options.label} ${names[i]}`, "number-box", (text) => {
		const value = parse(text, options);
		return typeof value === "string" ? value : (change(i, value), null);
	}));
	let drag = "";
	const picker = colored && el<HTMLInputElement>("input", {
		type: "color", id: options.id, "aria-label": options.label, oninput: (event: Event) => {
			drag ||= startDrag();
			const code = parseInt((picker as HTMLInputElement).value.slice(1), 16);
			const linear = [16, 8, 0].map((shift) => Number(srgbToLinear(((code >> shift) & 255) / 255).toPrecision(4)));
			values = [...linear, ...values.slice(3)];
			options.send(values, drag, event.timeStamp);
		}, onchange: () => (drag = ""),
	});
	return {
		element: el("div", { class: "control parts" }, picker, fields.map(({ input }, i) => el("label", {}, el("span", { "aria-hidden": "true" }, names[i]), input))),
		show: (value) => {
			if (Array.isArray(value) && !drag) {
				values = value.map(Number);
				values.forEach((part, i) => fields[i]?.show(String(Number(part.toPrecision(6)))));
				if (picker) {
					picker.value = "#" + values.slice(0, 3).map((part) => Math.round(255 * linearToSrgb(Math.min(Math.max(part, 0), 1))).toString(16).padStart(2, "0")).join("");
				}
			}
		},
	};
}

/** The pictures beside the config, to choose from. */
async function listPictures(): Promise<void> {
	const { pictures } = await get<{ pictures: string[] }>("pictures").catch(() => ({ pictures: [] }));
	const list = document.querySelector("#pictures") ?? document.body.appendChild(el("datalist", { id: "pictures" }));
	list.replaceChildren(...pictures.map((value) => el("option", { value })));
}

function makeText(options: ControlOptions): Control {
	const field = makeField(options, options.label, "text-box", (text) => {
		try {
			options.send(text.trim() === "" ? null : /^\s*[[{]/.test(text) ? (JSON.parse(text) as Json) : text);
			return null;
		} catch (mistake) {
			return `This is not JSON: ${(mistake as Error).message}`;
		}
	});
	field.input.id = options.id;
	field.input.placeholder = options.objectClass === "CurveFloat" ? "none, or keys: linear(-4 1, 0 0, 4 -1)" : options.objectClass ? "none, or the path of a picture" : "none";
	if (options.objectClass?.startsWith("Texture")) {
		field.input.setAttribute("list", "pictures");
		field.input.addEventListener("focus", () => void listPictures());
	}
	return { element: el("div", { class: "control" }, field.input), show: (value) => field.show(value === null ? "" : typeof value === "string" ? value : JSON.stringify(value)) };
}

export function makeControl(options: ControlOptions): Control {
	const { value, id, label } = options;
	let control: Control;
	if (options.enum?.length) {
		const select = el<HTMLSelectElement>("select", { id, "aria-label": label, onchange: () => options.send(select.value) }, options.enum.map((name) => el("option", { value: name }, name)));
		control = { element: el("div", { class: "control" }, select), show: (now) => (select.value = typeof now === "number" ? options.enum![now] : String(now)) };
	} else if (typeof value === "boolean") {
		const box = el<HTMLInputElement>("input", { type: "checkbox", id, "aria-label": label, onchange: () => options.send(box.checked) });
		control = { element: el("div", { class: "control" }, box, el("label", { for: id, class: "quiet" }, "on")), show: (now) => (box.checked = now === true) };
	} else if (typeof value === "number") {
		control = makeNumber(options);
	} else if (Array.isArray(value) && value.length <= 4 && value.every((part) => typeof part === "number")) {
		control = makeParts(options, value as number[], /colou?r/i.test(options.type));
	} else {
		control = makeText(options);
	}
	control.show(value);
	return control;
}
