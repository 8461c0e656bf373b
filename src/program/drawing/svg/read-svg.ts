import { at, part } from "../../../kernel/geometry/point.ts";
import { attributeOf, elementsIn, readXml, textInside, type XmlElement } from "../../files/xml.ts";
import { decoded } from "../decode.ts";
import type { Drawing, DrawingGiven, DrawingNote, DrawingUnit, DrawnCurve, DrawnText, LineRole } from "../drawing.ts";
import { FIT, plainCurve } from "../fit.ts";
import { roleOfName, roleOfPattern, rolesByWeight } from "../roles.ts";
import { after, placed, placedCurve, shift, stretch, UNPLACED, type Curve3, type Placing } from "../space.ts";
import { lengthOf, shapeCurves } from "./svg-shapes.ts";
import { numbersOf } from "./svg-path.ts";
import { propertyOf, rulesOf, type SvgRules } from "./svg-style.ts";
import { transformOf } from "./svg-transform.ts";

/** Limits: curves and texts of a drawing, elements that are repeated by reference, nested references. */
const MOST = { curves: 20_000, texts: 500, repeated: 10_000, nested: 20 };
/** Elements whose content is shown only by reference, or never. */
const UNSHOWN =
  /^(defs|symbol|clipPath|mask|pattern|marker|metadata|style|script|title|desc|namedview|filter|\w*[gG]radient)$/;
const SHOWN = /^(svg|g|a|switch)$/;

interface Shape {
  readonly curve: Curve3;
  readonly kind: string;
  readonly layer: string;
  readonly role: LineRole;
  readonly weight: number | null;
}

/** What is handed down from an element to those inside it. */
interface Inherited {
  readonly placing: Placing;
  readonly layer: string;
  readonly role: LineRole;
  /** Inherited properties as written. */
  readonly stroke: string;
  readonly fill: string;
  readonly dashes: string;
  readonly width: string;
  readonly visible: boolean;
  readonly nested: number;
}

const START: Inherited = {
  placing: UNPLACED,
  layer: "",
  role: "outline",
  stroke: "none",
  fill: "black",
  dashes: "none",
  width: "1",
  visible: true,
  nested: 0,
};

class Walk {
  readonly shapes: Shape[] = [];
  readonly texts: { readonly text: string; readonly placing: Placing; readonly x: number; readonly y: number }[] = [];
  readonly skipped = new Map<string, number>();
  invisible = 0;
  broken = 0;
  repeated = 0;
  isFull = false;
  private readonly rules: SvgRules;
  private readonly byId = new Map<string, XmlElement>();

  constructor(root: XmlElement) {
    this.rules = rulesOf(root);
    const name = (e: XmlElement) => {
      const id = attributeOf(e, "id");
      if (id !== undefined && !this.byId.has(id)) this.byId.set(id, e);
      elementsIn(e).forEach(name);
    };
    name(root);
  }

  /** Walks what the outermost element shows. */
  all(root: XmlElement) {
    const here = this.inherited(root, START);
    elementsIn(root).forEach((c) => this.visit(c, here));
    return this;
  }

  private inherited(e: XmlElement, from: Inherited): Inherited {
    const own = (property: string) => propertyOf(e, this.rules, property),
      // Inkscape names layers by a label, others by an id.
      isGroup = SHOWN.test(e.local) && e.local !== "svg",
      label = isGroup ? (attributeOf(e, "label") ?? attributeOf(e, "id")) : undefined;
    const named = label === undefined ? "outline" : roleOfName(label),
      visibility = own("visibility");
    return {
      placing: after(from.placing, transformOf(attributeOf(e, "transform"))),
      layer: label ?? from.layer,
      role: named === "outline" ? from.role : named,
      stroke: own("stroke") ?? from.stroke,
      fill: own("fill") ?? from.fill,
      dashes: own("stroke-dasharray") ?? from.dashes,
      width: own("stroke-width") ?? from.width,
      visible: visibility === undefined ? from.visible : visibility === "visible",
      nested: from.nested,
    };
  }

  private visit(e: XmlElement, from: Inherited) {
    if (this.isFull || UNSHOWN.test(e.local)) return;
    if (propertyOf(e, this.rules, "display") === "none") {
      this.invisible += countOf(e);
      return;
    }
    const here = this.inherited(e, from);
    if (e.local === "svg") {
      const inner = { ...here, placing: nestedPlacing(e, here.placing) };
      elementsIn(e).forEach((c) => this.visit(c, inner));
    } else if (SHOWN.test(e.local)) elementsIn(e).forEach((c) => this.visit(c, here));
    else if (e.local === "use") this.use(e, here);
    else if (e.local === "text") this.text(e, here);
    else this.shape(e, here);
  }
  private use(e: XmlElement, here: Inherited) {
    const target = this.byId.get((attributeOf(e, "href") ?? "").replace(/^#/, "")),
      size = (name: string) => lengthOf(attributeOf(e, name))?.px ?? 0;
    this.repeated += 1;
    if (!target || here.nested >= MOST.nested || this.repeated > MOST.repeated) {
      this.broken += 1;
      return;
    }
    const inner = { ...here, nested: here.nested + 1, placing: after(here.placing, shift([size("x"), size("y"), 0])) };
    if (target.local === "symbol") elementsIn(target).forEach((c) => this.visit(c, inner));
    else this.visit(target, inner);
  }

  private text(e: XmlElement, here: Inherited) {
    const text = textInside(e).replace(/\s+/g, " ").trim(),
      inner = [e, ...elementsIn(e)];
    const first = (name: string) =>
      inner
        .map(
          (i) =>
            lengthOf(
              attributeOf(i, name)
                ?.trim()
                .split(/[\s,]+/)[0],
            )?.px,
        )
        .find((n) => n !== undefined) ?? 0;
    if (text !== "" && here.visible && this.texts.length < MOST.texts)
      this.texts.push({ text, placing: here.placing, x: first("x"), y: first("y") });
  }

  private shape(e: XmlElement, here: Inherited) {
    const made = shapeCurves(e);
    if (!made) {
      this.skipped.set(e.local, (this.skipped.get(e.local) ?? 0) + 1);
      return;
    }
    if (!made.complete) this.broken += 1;
    if (!here.visible || (here.stroke === "none" && here.fill === "none")) {
      this.invisible += 1;
      return;
    }
    const dashes = here.dashes === "none" ? [] : numbersOf(here.dashes).filter((n) => n > 0),
      // An odd list is repeated once (SVG 2, 13.5.6): one number is a dash and a gap.
      role =
        here.role === "outline"
          ? roleOfPattern(dashes.length % 2 === 1 ? 2 * dashes.length : dashes.length)
          : here.role,
      weight = here.stroke === "none" ? null : (lengthOf(here.width)?.px ?? 1);
    for (const curve of made.curves)
      this.shapes.push({ curve: placedCurve(here.placing, curve), kind: e.local, layer: here.layer, role, weight });
    this.isFull ||= this.shapes.length > MOST.curves;
  }
}

/** Number of drawn elements inside one. */
const countOf = (e: XmlElement): number =>
  SHOWN.test(e.local) ? elementsIn(e).reduce((sum, c) => sum + countOf(c), 0) : UNSHOWN.test(e.local) ? 0 : 1;

/** Box of the user coordinates shown; null where none or an empty one is given. */
function viewBox(e: XmlElement) {
  const [x = 0, y = 0, width = 0, height = 0] = numbersOf(attributeOf(e, "viewBox") ?? "");
  return width > 0 && height > 0 ? { x, y, width, height } : null;
}

/** px per user unit of an svg element of these sizes. */
function scaleOf(e: XmlElement): number {
  const box = viewBox(e),
    [width, height] = [lengthOf(attributeOf(e, "width"))?.px, lengthOf(attributeOf(e, "height"))?.px];
  if (!box) return 1;
  const scales = [width && width / box.width, height && height / box.height].filter((s) => s !== undefined && s > 0);
  return scales.length > 0 ? Math.min(...(scales as number[])) : 1;
}

/** Places the content of an svg element inside another. */
function nestedPlacing(e: XmlElement, outside: Placing): Placing {
  const size = (name: string) => lengthOf(attributeOf(e, name))?.px ?? 0,
    box = viewBox(e),
    k = scaleOf(e);
  return after(
    after(outside, shift([size("x"), size("y"), 0])),
    after(stretch(k, k, 1), box ? shift([-box.x, -box.y, 0]) : UNPLACED),
  );
}

const refused = (note: DrawingNote): Drawing => ({
  curves: [],
  unit: { unit: "mm", source: "assumed" },
  texts: [],
  tolerance: 0,
  notes: [note],
});

/** Units of a width or height from which the size of the drawing on paper follows. */
const LENGTHS = ["mm", "cm", "q", "in", "pt", "pc"];

/** Size of a user unit in mm: as the width and height say, or the chosen one; px are 1/96 inch. */
function unitOf(
  root: XmlElement,
  chosen: DrawingUnit["unit"] | undefined,
): { readonly unit: DrawingUnit; readonly mm: number } {
  if (chosen) return { unit: { unit: chosen, source: "chosen" }, mm: chosen === "inch" ? 25.4 : 1 };
  const given = (["width", "height"] as const).flatMap((name) => lengthOf(attributeOf(root, name)) ?? []);
  const named = given.find((l) => LENGTHS.includes(l.unit)),
    mm = (scaleOf(root) * 25.4) / 96;
  return { unit: { unit: named?.unit === "in" ? "inch" : "mm", source: named ? "file" : "assumed" }, mm };
}

function notesOf(walk: Walk, isCut: boolean, fitted: ReadonlyMap<string, number>): DrawingNote[] {
  const notes: DrawingNote[] = [];
  if (isCut) notes.push({ code: "truncated", severity: "warning", values: {} });
  if (walk.invisible > 0) notes.push({ code: "invisible", severity: "warning", values: { count: walk.invisible } });
  walk.skipped.forEach((count, kind) => notes.push({ code: "skipped", severity: "info", values: { kind, count } }));
  if (walk.broken > 0) notes.push({ code: "broken", severity: "warning", values: { count: walk.broken } });
  fitted.forEach((count, kind) =>
    notes.push({ code: "fitted", severity: "info", values: { kind, count, tolerance: FIT } }),
  );
  return notes;
}

/**
 * Reads an SVG file: basic shapes and paths with their transforms, x of the file as z and y, which points downwards there,
 * as -r; in mm by its width and height. Hidden elements are left out and named. Never throws.
 */
export function readSvg(bytes: Uint8Array, { unit: chosen }: DrawingGiven = {}): Drawing {
  const { root, faults, faultCount } = readXml(decoded(bytes));
  if (!root || root.local !== "svg") return refused({ code: "unreadable", severity: "error", values: { kind: "SVG" } });
  const walk = new Walk(root).all(root);
  const { unit, mm } = unitOf(root, chosen),
    upright = stretch(mm, -mm, 1),
    fitted = new Map<string, number>();
  const plain = walk.shapes.map((s) => {
    const made = plainCurve(placedCurve(upright, s.curve));
    if (made.isFitted) fitted.set(s.kind, (fitted.get(s.kind) ?? 0) + 1);
    return { ...s, segments: made.segments, length: made.segments.reduce((sum, c) => sum + part.lengthOf(c), 0) };
  });
  const roles = rolesByWeight(plain),
    curves = plain.flatMap(({ segments, layer, kind, role }, i): DrawnCurve[] =>
      segments
        .filter((s) => [s.from, s.to].every((p) => Number.isFinite(p.z) && Number.isFinite(p.r)))
        .map((segment) => ({ segment, layer, kind, role: roles[i] ?? role })),
    );
  if (walk.isFull || curves.length > MOST.curves)
    return refused({ code: "tooMany", severity: "error", values: { limit: MOST.curves } });
  const texts = walk.texts.map(({ text, placing, x, y }): DrawnText => {
    const [px, py] = placed(after(upright, placing), [x, y, 0]);
    return { text, at: at(px, py) };
  });
  const isCut = faults.some((f) => f.code === "cut" || f.code === "tooDeep" || f.code === "tooMany");
  walk.broken += isCut ? faultCount - 1 : faultCount;
  return { curves, unit, texts, tolerance: fitted.size > 0 ? FIT : 0, notes: notesOf(walk, isCut, fitted) };
}
