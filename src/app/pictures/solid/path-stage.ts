import { BufferGeometry, DoubleSide, Group, LessDepth } from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import type { PathRole } from "../../../view/scene.ts";
import { piecesFrom, thinned, type SpaceLines } from "../../../view/solid/path-lines.ts";
import { PIECE, piecesGeometry, wideLines } from "./lines.ts";

/** Meaning of lines: a line style of the path, or a tone of the colour map; null without a value. */
export type LineLook = { readonly role: PathRole } | { readonly tone: number | null };

/** Lines of one look. Those of the path fade once done. */
export interface StageLines extends SpaceLines {
  readonly look: LineLook;
}

/** Colours of the page, by the custom properties that hold them. */
export const LINE_COLOURS = {
  feed: "--feed",
  rapid: "--rapid",
  untold: "--text-soft",
  tone0: "--load-0",
  tone1: "--load-1",
  tone2: "--load-2",
  tone3: "--load-3",
  tone4: "--load-4",
  tone5: "--load-5",
  tone6: "--load-6",
} as const;
type LineColours = Readonly<Record<keyof typeof LINE_COLOURS, string>>;

interface Form {
  readonly wide: number;
  /** Dash and gap; lines without one are whole. */
  readonly dash?: readonly [number, number];
}

/** The line styles of the drawing, pixels. */
const FORMS: Readonly<Record<PathRole, Form>> = {
  rapid: { wide: 1, dash: [6, 4] },
  feed: { wide: 1.5 },
  plunge: { wide: 2, dash: [2, 3] },
  smooth: { wide: 1.5, dash: [14, 2] },
  finish: { wide: 3 },
  thread: { wide: 1.5, dash: [8, 3] },
};
const TONES = [1.5, 2.25, 3, 3.5, 4.25, 5, 5.75] as const;
const UNTOLD: Form = { wide: 2, dash: [2, 3] };
/** Opacity of lines: coming, done, and the path under a colour map. */
const STRENGTH = { coming: 0.75, done: 0.22, under: 0.2, told: 1 } as const;

/** With more pieces than this, pieces that look alike are drawn once: ends closer than this are the same, pixels. */
const MANY = 4000,
  FINE = 1;

/** Resolution of a path with many pieces, mm: one of a few steps, since each is built separately. */
const fineness = (pixel: number): number => 2 ** Math.floor(Math.log2(FINE * pixel));

/** Lines on the stage. */
export interface PathStage {
  readonly group: Group;
  readonly set: (lines: readonly StageLines[]) => void;
  /** Sets the running step. */
  readonly runs: (step: number) => void;
  readonly setColours: (colours: LineColours) => void;
  /** Sets the size of one pixel, mm. */
  readonly setPixel: (mm: number) => void;
  readonly dispose: () => void;
}

const formOf = (look: LineLook): Form => {
  if ("role" in look) return FORMS[look.role];
  return look.tone === null ? UNTOLD : { wide: TONES[look.tone] ?? 1 };
};

function colourOf(look: LineLook, colours: LineColours): string {
  if ("role" in look) return look.role === "rapid" ? colours.rapid : colours.feed;
  return look.tone === null ? colours.untold : colours[`tone${look.tone}` as keyof LineColours];
}

/** The same pieces with a draw count of their own. */
function sharing(geometry: BufferGeometry): BufferGeometry {
  const other = new BufferGeometry();
  for (const [name, attribute] of Object.entries(geometry.attributes)) other.setAttribute(name, attribute);
  return other.setIndex(geometry.index);
}

/** The lines of the work. Of two overlapping ones the first is visible, and none is blended twice. */
export function createPathStage(): PathStage {
  const group = new Group();
  let drawn: readonly {
    readonly line: ReturnType<typeof wideLines>;
    readonly of: StageLines;
    readonly fades: boolean;
  }[] = [];
  let [colours, pixel, step]: [LineColours | null, number, number] = [null, 1, 0];
  let whole: readonly StageLines[] = [];

  const clear = () => {
    for (const { line } of drawn) {
      line.geometry.dispose();
      line.material.dispose();
      group.remove(line);
    }
    drawn = [];
  };
  const put = (of: StageLines, geometry: BufferGeometry, opacity: number, fades: boolean) => {
    const { wide, dash } = formOf(of.look);
    // With X downwards the world is mirrored, and a line would show its back.
    const material = new LineMaterial({
      linewidth: wide,
      transparent: true,
      opacity,
      dashed: dash !== undefined,
      depthFunc: LessDepth,
      side: DoubleSide,
    });
    if (dash) [material.dashSize, material.gapSize] = dash;
    const line = wideLines(geometry, material);
    line.renderOrder = group.children.length;
    group.add(line);
    return { line, of, fades };
  };
  const look = () => {
    for (const {
      line: { material, geometry },
      of,
      fades,
    } of drawn) {
      if (colours) material.color.set(colourOf(of.look, colours));
      material.dashScale = 1 / pixel;
      if (fades) geometry.setDrawRange(0, PIECE * piecesFrom(of, step));
    }
  };

  const isMany = () => whole.reduce((sum, { sources }) => sum + sources.length, 0) > MANY;
  const arrange = () => {
    clear();
    const lines = isMany() ? whole.map((each) => ({ ...each, ...thinned(each, fineness(pixel)) })) : whole;
    const told = lines.filter(({ look: l }) => "tone" in l).reverse(),
      path = lines.filter(({ look: l }) => "role" in l);
    const first = told.map((each) => put(each, piecesGeometry(each.places), STRENGTH.told, false));
    const made = path.map((of) => ({ of, geometry: piecesGeometry(of.places) }));
    const coming =
      told.length > 0 ? [] : made.map(({ of, geometry }) => put(of, sharing(geometry), STRENGTH.coming, true));
    const rest = made.map(({ of, geometry }) =>
      put(of, geometry, told.length > 0 ? STRENGTH.under : STRENGTH.done, false),
    );
    drawn = [...first, ...coming, ...rest];
    look();
  };

  return {
    group,
    set(lines) {
      whole = lines;
      arrange();
    },
    runs(now) {
      step = now;
      for (const { line, of, fades } of drawn) if (fades) line.geometry.setDrawRange(0, PIECE * piecesFrom(of, step));
    },
    setColours(next) {
      colours = next;
      look();
    },
    setPixel(mm) {
      const isOther = isMany() && fineness(mm) !== fineness(pixel);
      pixel = mm;
      if (isOther) arrange();
      for (const { line } of drawn) line.material.dashScale = 1 / pixel;
    },
    dispose: clear,
  };
}
