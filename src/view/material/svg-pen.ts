import type { Size } from "../camera.ts";
import type { Pen, PenGradient } from "./pen.ts";

const n = (v: number) => String(Math.round(v * 100) / 100 + 0);

type Matrix = readonly [number, number, number, number, number, number];

interface State {
  fillStyle: string | object;
  strokeStyle: string | object;
  lineWidth: number;
  globalAlpha: number;
  dashes: readonly number[];
  /** Number of open groups, because of clips. */
  groups: number;
}

/** A pen that records what a painter paints as SVG text, to be stored and compared. It counts in CSS pixels. */
export function svgPen(size: Size): { readonly pen: Pen; readonly text: () => string } {
  const defs: string[] = [],
    body: string[] = [],
    named = new Map<string, string>();
  const stops = new Map<object, { readonly line: readonly number[]; readonly list: string[] }>();
  let state: State = { fillStyle: "#000", strokeStyle: "#000", lineWidth: 1, globalAlpha: 1, dashes: [], groups: 0 };
  const kept: State[] = [];
  let matrix: Matrix = [1, 0, 0, 1, 0, 0];
  let path: string[] = [];

  const place = (x: number, y: number) =>
    `${n(matrix[0] * x + matrix[2] * y + matrix[4])} ${n(matrix[1] * x + matrix[3] * y + matrix[5])}`;
  function define(prefix: string, content: (id: string) => string): string {
    const key = content("");
    const id = named.get(key) ?? `${prefix}${named.size}`;
    if (!named.has(key)) {
      named.set(key, id);
      defs.push(content(id));
    }
    return id;
  }
  function paint(style: string | object): string {
    if (typeof style === "string") return style;
    const gradient = stops.get(style);
    if (!gradient) return "none";
    const [x1 = 0, y1 = 0, x2 = 0, y2 = 0] = gradient.line;
    const plain = define("shade", (id) => `<linearGradient id="${id}">${gradient.list.join("")}</linearGradient>`);
    const laid = define(
      "laid",
      (id) =>
        `<linearGradient id="${id}" href="#${plain}" gradientUnits="userSpaceOnUse" x1="${x1}" y1="${y1}" x2="${x2}" y2="${y2}" ` +
        `gradientTransform="matrix(${matrix.map(n).join(" ")})"/>`,
    );
    return `url(#${laid})`;
  }
  const alpha = () => (state.globalAlpha === 1 ? "" : ` opacity="${n(state.globalAlpha)}"`);
  const rule = (r?: string) => (r === "evenodd" ? ` fill-rule="evenodd"` : "");
  const fill = (d: string, r?: string) => {
    if (d !== "") body.push(`<path d="${d}" fill="${paint(state.fillStyle)}"${rule(r)}${alpha()}/>`);
  };
  const box = (x: number, y: number, width: number, height: number) =>
    `M${place(x, y)}L${place(x + width, y)}L${place(x + width, y + height)}L${place(x, y + height)}Z`;

  const pen: Pen = {
    get fillStyle() {
      return state.fillStyle;
    },
    set fillStyle(style) {
      state.fillStyle = style;
    },
    get strokeStyle() {
      return state.strokeStyle;
    },
    set strokeStyle(style) {
      state.strokeStyle = style;
    },
    get lineWidth() {
      return state.lineWidth;
    },
    set lineWidth(width) {
      state.lineWidth = width;
    },
    get globalAlpha() {
      return state.globalAlpha;
    },
    set globalAlpha(value) {
      state.globalAlpha = value;
    },
    save() {
      kept.push(state);
      state = { ...state, groups: 0 };
    },
    restore() {
      body.push(...Array<string>(state.groups).fill("</g>"));
      state = kept.pop() ?? state;
    },
    setTransform(...next: Matrix) {
      matrix = next;
    },
    clearRect() {},
    fillRect: (x, y, width, height) => fill(box(x, y, width, height)),
    createLinearGradient(...line) {
      const list: string[] = [];
      const gradient: PenGradient = {
        addColorStop: (at, colour) => void list.push(`<stop offset="${at}" stop-color="${colour}"/>`),
      };
      stops.set(gradient, { line, list });
      return gradient;
    },
    setLineDash(dashes) {
      state.dashes = dashes;
    },
    beginPath() {
      path = [];
    },
    moveTo: (x, y) => void path.push(`M${place(x, y)}`),
    lineTo: (x, y) => void path.push(`L${place(x, y)}`),
    closePath: () => void path.push("Z"),
    rect: (x, y, width, height) => void path.push(box(x, y, width, height)),
    clip(r) {
      const d = path.join("");
      const id = define(
        "clip",
        (name) => `<clipPath id="${name}"><path d="${d}"${r === "evenodd" ? ` clip-rule="evenodd"` : ""}/></clipPath>`,
      );
      body.push(`<g clip-path="url(#${id})">`);
      state.groups += 1;
    },
    fill: (r) => fill(path.join(""), r),
    stroke() {
      const dashes = state.dashes.length > 0 ? ` stroke-dasharray="${state.dashes.join(" ")}"` : "";
      if (path.length > 0)
        body.push(
          `<path d="${path.join("")}" fill="none" stroke="${paint(state.strokeStyle)}" stroke-width="${n(
            state.lineWidth,
          )}"${dashes}${alpha()}/>`,
        );
    },
  };
  const text = () =>
    [
      `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${n(size.width)} ${n(size.height)}">`,
      `<defs>`,
      ...defs,
      `</defs>`,
      ...body,
      `</svg>`,
      "",
    ].join("\n");
  return { pen, text };
}
