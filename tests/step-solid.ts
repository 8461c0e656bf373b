import { at, part, type Pt, type Segment } from "../src/kernel/geometry/point.ts";

/** A point or direction of a solid. */
export type V = readonly [number, number, number];

/** How a system writes the same solid. */
export interface Manner {
  /** Faces of revolution in one piece with a seam, in two halves, or in one piece between two circles. */
  readonly faces: "seam" | "halves" | "circles";
  readonly unit: "mm" | "inch" | "m";
  readonly degrees: boolean;
  /** Every surface of revolution but planes as a rational spline, or as a profile turned about the axis. */
  readonly surfaces: "plain" | "spline" | "revolution";
  /** Axis of the part in the file: z, or x, beside the origin. */
  readonly axis: "z" | "x";
}

/** In the manner of a modeller, of two mechanical systems, and of a converter that knows splines only. */
export const MANNERS = {
  seams: { faces: "seam", unit: "mm", degrees: false, surfaces: "plain", axis: "z" },
  halves: { faces: "halves", unit: "m", degrees: false, surfaces: "revolution", axis: "z" },
  inches: { faces: "circles", unit: "inch", degrees: true, surfaces: "plain", axis: "x" },
  splines: { faces: "halves", unit: "mm", degrees: false, surfaces: "spline", axis: "x" },
} satisfies Record<string, Manner>;

/** Writes a STEP file of one solid from faces. */
export class Solid {
  private readonly lines: string[] = [];
  private faces: string[] = [];
  private readonly solids: { readonly product: string; readonly id: string }[] = [];
  private readonly manner: Manner;
  private readonly known = new Map<string, string>();

  constructor(manner: Manner) {
    this.manner = manner;
  }

  /** An entity; equal ones are written once. */
  private put(text: string): string {
    const known = this.known.get(text);
    if (known) return known;
    const id = `#${this.lines.length * 3 + 11}`;
    this.lines.push(`${id}=${text};`);
    this.known.set(text, id);
    return id;
  }

  private readonly length = (mm: number) =>
    (mm / { mm: 1, inch: 25.4, m: 1000 }[this.manner.unit]).toExponential(14).replace("e", "E");

  /** A place of the file: the part's axis is z or x, 5 mm beside the origin. */
  private place([x, y, z]: V): V {
    return this.manner.axis === "z" ? [x + 5, y, z] : [z, x + 5, y];
  }

  point(p: V): string {
    return this.put(`CARTESIAN_POINT('',(${this.place(p).map(this.length).join(",")}))`);
  }

  direction([x, y, z]: V): string {
    const turned: V = this.manner.axis === "z" ? [x, y, z] : [z, x, y];
    return this.put(`DIRECTION('',(${turned.map((n) => n.toExponential(15)).join(",")}))`);
  }

  private placement(p: V, z: V = [0, 0, 1], x: V = [1, 0, 0]): string {
    return this.put(`AXIS2_PLACEMENT_3D('',${this.point(p)},${this.direction(z)},${this.direction(x)})`);
  }

  private vertex = (p: V) => this.put(`VERTEX_POINT('',${this.point(p)})`);

  private edge(a: V, b: V, curve: string): string {
    return this.put(`EDGE_CURVE('',${this.vertex(a)},${this.vertex(b)},${curve},.T.)`);
  }

  /** An edge between two points: straight, or round about a centre, counter-clockwise about an axis. */
  straight(a: V, b: V): string {
    const d: V = [b[0] - a[0], b[1] - a[1], b[2] - a[2]],
      n = Math.hypot(...d);
    const vector = this.put(`VECTOR('',${this.direction([d[0] / n, d[1] / n, d[2] / n])},${this.length(1)})`);
    return this.edge(a, b, this.put(`LINE('',${this.point(a)},${vector})`));
  }

  round(a: V, b: V, centre: V, size: number, axis: V = [0, 0, 1]): string {
    const x: V = [(a[0] - centre[0]) / size, (a[1] - centre[1]) / size, (a[2] - centre[2]) / size];
    return this.edge(a, b, this.put(`CIRCLE('',${this.placement(centre, axis, x)},${this.length(size)})`));
  }

  /** A face: its surface, whether its normal is that of the surface, and its loops of edges, "-" for backwards. */
  face(surface: string, sense: boolean, ...loops: readonly (readonly string[])[]) {
    const bounds = loops.map((edges, i) => {
      const oriented = edges.map((e) =>
        this.put(`ORIENTED_EDGE('',*,*,${e.replace("-", "")},.${e.startsWith("-") ? "F" : "T"}.)`),
      );
      return this.put(
        `FACE_${i === 0 ? "OUTER_" : ""}BOUND('',${this.put(`EDGE_LOOP('',(${oriented.join(",")}))`)},.T.)`,
      );
    });
    this.faces.push(this.put(`ADVANCED_FACE('',(${bounds.join(",")}),${surface},.${sense ? "T" : "F"}.)`));
  }

  plane = (p: V, z: V, x: V = [1, 0, 0]) => this.put(`PLANE('',${this.placement(p, z, x)})`);
  cylinder = (p: V, size: number) => this.put(`CYLINDRICAL_SURFACE('',${this.placement(p)},${this.length(size)})`);

  /** Surface of a segment turned about the axis; its normal is left of the segment, as of `revolution` and `spline`. */
  private turned(s: Segment): { readonly surface: string; readonly isLeft: boolean } {
    const { surfaces, degrees } = this.manner,
      angle = (n: number) => String(degrees ? (n * 180) / Math.PI : n).replace(/^(-?\d+)$/, "$1.");
    if (surfaces === "revolution") {
      const axis = this.put(`AXIS1_PLACEMENT('',${this.point([0, 0, 0])},${this.direction([0, 0, 1])})`);
      return { surface: this.put(`SURFACE_OF_REVOLUTION('',${this.profile(s)},${axis})`), isLeft: true };
    }
    if (surfaces === "spline") return { surface: this.spline(s), isLeft: true };
    if (s.kind === "arc") {
      const [z, r] = [s.centre.z, s.centre.r],
        size = part.radiusOf(s),
        isLeft = s.turn === "cw";
      return Math.abs(r) < 1e-9
        ? { surface: this.put(`SPHERICAL_SURFACE('',${this.placement([0, 0, z])},${this.length(size)})`), isLeft }
        : {
            surface: this.put(
              `TOROIDAL_SURFACE('',${this.placement([0, 0, z])},${this.length(r)},${this.length(size)})`,
            ),
            isLeft,
          };
    }
    const [dz, dr] = [s.to.z - s.from.z, s.to.r - s.from.r];
    if (Math.abs(dz) < 1e-9) return { surface: this.plane([0, 0, s.from.z], [0, 0, -1]), isLeft: dr > 0 };
    const base = this.placement([0, 0, s.from.z]);
    const surface =
      Math.abs(dr) < 1e-9
        ? this.put(`CYLINDRICAL_SURFACE('',${base},${this.length(s.from.r)})`)
        : this.put(`CONICAL_SURFACE('',${base},${this.length(s.from.r)},${angle(Math.atan(dr / dz))})`);
    return { surface, isLeft: dz > 0 };
  }

  private profile(s: Segment): string {
    const p = (q: Pt): V => [q.r, 0, q.z];
    if (s.kind === "line") {
      const n = part.apart(s.from, s.to),
        d = this.direction([(s.to.r - s.from.r) / n, 0, (s.to.z - s.from.z) / n]);
      return this.put(`LINE('',${this.point(p(s.from))},${this.put(`VECTOR('',${d},${this.length(1)})`)})`);
    }
    return this.put(
      `CIRCLE('',${this.placement(p(s.centre), [0, s.turn === "ccw" ? 1 : -1, 0])},${this.length(part.radiusOf(s))})`,
    );
  }

  /** The segment as a rational spline turned in quarters. */
  private spline(s: Segment): string {
    const h = Math.SQRT1_2,
      middle = part.pointOn(s, 0.5);
    const bend = s.kind === "arc" ? Math.cos(part.sweepOf(s) / 2) : 1,
      corner =
        s.kind === "arc"
          ? at(s.centre.z + (middle.z - s.centre.z) / bend, s.centre.r + (middle.r - s.centre.r) / bend)
          : middle;
    const profile: readonly (readonly [Pt, number])[] = [
      [s.from, 1],
      [corner, bend],
      [s.to, 1],
    ];
    const circle: readonly (readonly [number, number, number])[] = [
      [1, 0, 1],
      [1, 1, h],
      [0, 1, 1],
      [-1, 1, h],
      [-1, 0, 1],
      [-1, -1, h],
      [0, -1, 1],
      [1, -1, h],
      [1, 0, 1],
    ];
    const rows = circle.map(([x, y]) => `(${profile.map(([q]) => this.point([x * q.r, y * q.r, q.z])).join(",")})`),
      weights = circle.map(([, , w]) => `(${profile.map(([, v]) => (w * v).toExponential(15)).join(",")})`);
    return this.put(
      `(BOUNDED_SURFACE()B_SPLINE_SURFACE(2,2,(${rows.join(",")}),.UNSPECIFIED.,.T.,.F.,.F.)B_SPLINE_SURFACE_WITH_KNOTS((3,2,2,2,3),(3,3),(0.,1.,2.,3.,4.),(0.,1.),.UNSPECIFIED.)GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_SURFACE((${weights.join(",")}))REPRESENTATION_ITEM('')SURFACE())`,
    );
  }

  /** A segment of the outline turned about the axis, the material on its right, with holes in it. */
  turn(s: Segment, ...holes: readonly (readonly string[])[]) {
    const { surface, isLeft } = this.turned(s),
      on = (q: Pt, x: number): V => [q.r * x, 0, q.z];
    const circle = (q: Pt, from: number, to: number) =>
      q.r < 1e-9 ? [] : [this.round(on(q, from), on(q, to), [0, 0, q.z], q.r)];
    const side = (x: number) => {
      const [a, b] = [on(s.from, x), on(s.to, x)];
      if (s.kind === "line") return this.straight(a, b);
      return this.round(a, b, on(s.centre, x), part.radiusOf(s), [0, (s.turn === "ccw" ? 1 : -1) * x, 0]);
    };
    const back = (edges: readonly string[]) => edges.map((e) => `-${e}`);
    if (this.manner.faces === "halves")
      for (const [from, to] of [
        [1, -1],
        [-1, 1],
      ] as const)
        this.face(surface, isLeft, [
          ...circle(s.from, from, to),
          side(to),
          ...back(circle(s.to, from, to)),
          ...back([side(from)]),
        ]);
    else if (this.manner.faces === "seam")
      this.face(
        surface,
        isLeft,
        [...circle(s.from, 1, 1), side(1), ...back(circle(s.to, 1, 1)), ...back([side(1)])],
        ...holes,
      );
    else this.face(surface, isLeft, ...[circle(s.from, 1, 1), back(circle(s.to, 1, 1))].filter((l) => l.length > 0));
  }

  /** The faces since the last body are one; an empty product is none. */
  body(product: string, name: string) {
    const shell = this.put(`CLOSED_SHELL('',(${this.faces.join(",")}))`);
    this.solids.push({ product, id: this.put(`MANIFOLD_SOLID_BREP('${name}',${shell})`) });
    this.faces = [];
  }

  /** A representation of the bodies of a product, or of those without one. */
  private represent(product: string, context: string) {
    const ids = this.solids.filter((s) => s.product === product).map((s) => s.id);
    const shape = this.put(`ADVANCED_BREP_SHAPE_REPRESENTATION('${product}',(${ids.join(",")}),${context})`);
    if (product === "") return;
    const named = this.put(`SHAPE_REPRESENTATION('${product}',(),${context})`);
    this.put(`SHAPE_REPRESENTATION_RELATIONSHIP('','',${named},${shape})`);
    const formation = this.put(`PRODUCT_DEFINITION_FORMATION('','',${this.put(`PRODUCT('id','${product}','',())`)})`),
      definition = this.put(`PRODUCT_DEFINITION('design','',${formation},$)`);
    this.put(`SHAPE_DEFINITION_REPRESENTATION(${this.put(`PRODUCT_DEFINITION_SHAPE('','',${definition})`)},${named})`);
  }

  text(): string {
    if (this.faces.length > 0) this.body("", "Part");
    const mm = this.put("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))"),
      radian = this.put("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
    const converted = (name: string, size: string, of: string, kind: string) =>
      this.put(
        `(CONVERSION_BASED_UNIT('${name}',${this.put(`${kind}_MEASURE_WITH_UNIT(${kind}_MEASURE(${size}),${of})`)})${kind}_UNIT()NAMED_UNIT(*))`,
      );
    const units = {
      mm,
      inch: this.manner.unit === "inch" ? converted("INCH", "25.4", mm, "LENGTH") : mm,
      m: this.put("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.))"),
    };
    const angle = this.manner.degrees ? converted("DEGREE", "1.74532925199433E-2", radian, "PLANE_ANGLE") : radian,
      context = this.put(
        `(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((${units[this.manner.unit]},${angle}))REPRESENTATION_CONTEXT('',''))`,
      );
    for (const product of new Set(this.solids.map((s) => s.product))) this.represent(product, context);
    return `ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\n${this.lines.join("\n")}\nENDSEC;\nEND-ISO-10303-21;\n`;
  }
}
