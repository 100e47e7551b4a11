// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers and elements. Text from the result only ever becomes text nodes.

const kMinus = "\u2212", kTimes = "\u00d7", kInfinity = "\u221e", kDash = "\u2013";

const kSuperscripts = "\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079";

function superscript(power: number): string {
  return (power < 0 ? "\u207b" : "") + [...String(Math.abs(power))].map((d) => kSuperscripts[Number(d)]).join("");
}

export function powerOfTen(value: number): string {
  return `10${superscript(Math.round(Math.log10(value)))}`;
}

/** A number to read, with so many digits; `null` and not finite ones are infinite in a result. */
export function readable(value: number | null | undefined, digits = 4): string {
  if (value === undefined) return kDash;
  if (value === null || !Number.isFinite(value)) return kInfinity;
  if (value === 0) return "0";
  const size = Math.abs(value), sign = value < 0 ? kMinus : "";
  if (size >= 1e-3 && size < 1e6) {
    const text = size >= 10 ** digits ? size.toFixed(0) : size.toPrecision(digits);
    return sign + text;
  }
  const [mantissa, power] = size.toExponential(Math.max(0, digits - 2)).split("e");
  return `${sign}${mantissa}\u202f${kTimes}\u202f10${superscript(Number(power))}`;
}

/** Fixed digits after the point, for coordinates that change under the pointer. */
export function coordinate(value: number, extent: number): string {
  const digits = Math.min(12, Math.max(0, 4 - Math.floor(Math.log10(extent || 1))));
  return value.toFixed(digits).replace("-", kMinus);
}

/** The same in little space, as programs write it. */
export function compact(value: number | null | undefined): string {
  if (value == null || value === 0 || (Math.abs(value) >= 1e-3 && Math.abs(value) < 1e4)) return readable(value, 3);
  return value.toExponential(1).replace(/-/g, kMinus);
}

export function plural(count: number, one: string, many: string): string {
  return `${count.toLocaleString("en")} ${count === 1 ? one : many}`;
}

export function element<K extends keyof HTMLElementTagNameMap>(
    tag: K, text = "", attributes: Record<string, string> = {}): HTMLElementTagNameMap[K] {
  const out = document.createElement(tag);
  if (text) out.textContent = text;
  for (const [name, value] of Object.entries(attributes)) out.setAttribute(name, value);
  return out;
}

/** The element of that id; it is in the page's own mark-up. */
export function byId<T extends HTMLElement>(id: string): T {
  const found = document.getElementById(id);
  if (!found) throw new Error(`no element #${id}`);
  return found as T;
}

/** A row of a table: what, and one or more values. */
export function row(name: string, values: string[], title = ""): HTMLTableRowElement {
  const out = element("tr");
  const head = element("th", name, { scope: "row" });
  if (title) head.title = title;
  out.append(head, ...values.map((value) => element("td", value)));
  return out;
}
