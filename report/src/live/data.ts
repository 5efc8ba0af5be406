// The types of the answers of `drydock live` (docs/live.md) that the page reads.
import { Effect } from "../data";

export type Json = null | boolean | number | string | Json[] | { [key: string]: Json };

/** A change of the config's JSON; the pointer is RFC 6901's. */
export type Edit = { set: string; value: Json } | { remove: string };

export interface Message {
	severity: string;
	code: string;
	message: string;
	where: string;
	file?: string;
	line?: number;
}

export interface LiveSetting {
	name: string;
	display: string;
	category: string; // "Lens|Bloom"
	type: string;
	class: string; // of an object's type, as "Texture2D"
	value: Json; // as blended
	default: Json;
	start: Json;
	overridden: boolean; // by the camera
	inVolumes: string[];
	range?: { clampMin: number | null; clampMax: number | null; uiMin: number | null; uiMax: number | null };
	enum?: string[];
	unit: string;
	doc: string;
	effect: string;
	unread: string; // why no active pass reads it; empty: one does
	plugin: string;
}

export interface LiveVolume {
	name: string;
	priority: number;
	blendWeight: number;
	blendRadius: number;
	unbound: boolean;
	enabled: boolean;
	bounds: { [key: string]: Json } | null;
	distance: number | null;
	weight: number;
	skipped: string | null;
}

export interface Variable {
	name: string;
	value: Json;
	default: Json;
	setBy?: string;
	matters: boolean;
	doc?: string;
}

export interface Dot {
	milliseconds: number;
	error: number;
	metric: string;
	label: string;
	revision: number;
}

export interface Frame {
	revision: number;
	width: number;
	height: number;
	milliseconds: { passes: number; setup: number; whole: number };
	passesRun: number;
	passesReused: number;
	passes: { index: number; name: string; ms: number; reused: boolean }[];
	messages: Message[];
	effects: Effect[];
}

export interface State {
	revision: number;
	name: string;
	config: string;
	canUndo: boolean;
	canRedo: boolean;
	changed: boolean;
	settings: LiveSetting[];
	volumes: LiveVolume[];
	view: { location: number[]; rotation?: number[]; path?: number[][] };
	sequence: { frame: number; frames: number[] } | null;
	variables: Variable[];
	showFlags: Variable[];
	pins: { pin: number; name: string; revision: number }[];
	dots: Dot[];
	frame: Frame | null;
	fault: { messages: Message[] } | null;
}

/** A key of a JSON pointer. */
export const escapeKey = (key: string): string => key.replaceAll("~", "~0").replaceAll("/", "~1");

/** The place of a setting in the config: of a volume, or with -1 of the camera. */
export const pointTo = (volume: number, setting: string): string => `${volume < 0 ? "/camera" : `/volumes/${volume}`}/Settings/${escapeKey(setting)}`;
