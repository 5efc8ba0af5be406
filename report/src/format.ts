// Numbers as people read them.

/** Four significant digits, and exponents only where they save room. */
export function number(value: number): string {
	if (!Number.isFinite(value)) {
		return Number.isNaN(value) ? "NaN" : value > 0 ? "+Inf" : "−Inf";
	}
	const size = Math.abs(value);
	if (value === 0 || Number.isInteger(value) && size < 1e7) {
		return String(value);
	}
	return size >= 1e6 || size < 1e-3 ? value.toExponential(3).replace(/\.?0+e/, "e") : String(Number(value.toPrecision(4)));
}

export function ms(value: number): string {
	if (value < 0.1) {
		return (value * 1000).toFixed(value < 0.01 ? 1 : 0) + " µs";
	}
	return value >= 1000 ? (value / 1000).toFixed(2) + " s" : value >= 10 ? value.toFixed(0) + " ms" : value.toFixed(2) + " ms";
}

export function bytes(value: number): string {
	return value >= 1e6 ? (value / 1e6).toFixed(1) + " MB" : value >= 1e3 ? (value / 1e3).toFixed(0) + " kB" : value + " B";
}

export function count(value: number, one: string, many = one + "s"): string {
	return `${value.toLocaleString("en")} ${value === 1 ? one : many}`;
}

export function big(value: number): string {
	return value >= 1e6 ? (value / 1e6).toFixed(1) + " M" : value >= 1e4 ? (value / 1e3).toFixed(0) + " k" : String(value);
}

export function percent(share: number): string {
	const value = 100 * share;
	return (value > 0 && value < 0.1 ? "< 0.1" : value.toFixed(value < 10 ? 1 : 0)) + " %";
}

/** A setting's value. */
export function value(of: unknown): string {
	if (typeof of === "number") {
		return number(of);
	}
	if (Array.isArray(of)) {
		return of.map(value).join(", ");
	}
	if (of !== null && typeof of === "object") {
		return Object.entries(of).map(([name, member]) => `${name} ${value(member)}`).join(", ");
	}
	return of === null || of === "" ? "none" : String(of);
}

export function time(utc: string): string {
	return utc.replace("T", " ").replace("Z", " UTC");
}
