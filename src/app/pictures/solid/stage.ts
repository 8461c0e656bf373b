import {
  BufferAttribute,
  BufferGeometry,
  Color,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh as Triangles,
  PerspectiveCamera,
  Scene as Space,
  Sphere,
  WebGLRenderer,
  type Material,
} from "three";
import type { Chip } from "../../../sim/chip/chip.ts";
import type { Size } from "../../../view/camera.ts";
import type { DrawnPart } from "../../../view/solid/machine-parts.ts";
import type { Mesh } from "../../../view/solid/mesh.ts";
import { eyeOf, FIELD, pixelAt, type Orbit } from "../../../view/solid/orbit.ts";
import type { MomentBody } from "../../../view/solid/moment.ts";
import { createChipStage } from "./chip-stage.ts";
import { createPathStage, LINE_COLOURS, type StageLines } from "./path-stage.ts";
import { hatched } from "./section-material.ts";
import { createSmoothEdges } from "./smooth-edges.ts";
import { LOOKS_ATTRIBUTE, surface } from "./surface-material.ts";
import { chuckTones } from "./tone.ts";

/** Colours of the page, by the custom properties that hold them. */
export const STAGE_COLOURS = {
  material: "--material",
  turned: "--steel-turned",
  hatch: "--material-hatch",
  steelDark: "--steel-dark",
  steelLight: "--steel-light",
  line: "--contour",
  surface: "--surface",
  chuck: "--chuck",
  chuckDark: "--chuck-dark",
  insert: "--insert",
  holder: "--holder",
  residual: "--residual",
  danger: "--danger",
  accent: "--accent",
  ...LINE_COLOURS,
} as const;

/** Bodies, light and eye on a canvas. Only `draw` draws. */
export interface SolidStage {
  /** Sets the size of the canvas, and how much of it is below the picture, CSS pixels. */
  readonly setSize: (size: Size, below: number, ratio: number) => void;
  /**
   * Share of the pixels along each side, 0 … 1; the page scales the picture up. Below 1 edges are not smoothed. Draw in
   * the same frame, since this clears the canvas.
   */
  readonly setShare: (share: number) => void;
  readonly setColours: (colours: Readonly<Record<keyof typeof STAGE_COLOURS, string>>) => void;
  readonly setBodies: (bodies: readonly MomentBody[]) => void;
  readonly setChuck: (parts: readonly DrawnPart[]) => void;
  readonly setTool: (parts: readonly DrawnPart[]) => void;
  /** Position of the tool tip, mm; null without a tool. */
  readonly placeTool: (tip: { readonly z: number; readonly r: number } | null) => void;
  /** The chip of the running cut; null if there is none. */
  readonly setChip: (chip: Chip | null) => void;
  /** Path and colour map. */
  readonly setLines: (lines: readonly StageLines[]) => void;
  /** Sets the running step; lines before it are done. */
  readonly setStep: (step: number) => void;
  /** Mirrors the view so that X grows downwards. */
  readonly turnOver: (down: boolean) => void;
  /** `reach`: largest distance of a body from the centre, mm. */
  readonly draw: (orbit: Orbit, size: Size, reach: number) => void;
  /** Frees all resources of the graphics card. */
  readonly dispose: () => void;
}

/** Share of the holder's colour in that of the insert, 0 … 1: lit from the front it would lose its shape. */
const MUTED = 0.3;
/** Pixels between two lines of a hatch. */
const HATCH = 8;
/**
 * Residual material is too thin for hatch lines to show it: its background has its colour, and the lines are paler by
 * this, 0 … 1.
 */
const PALE = 0.3;

function geometryOf({ positions, normals, index, looks }: Mesh): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  geometry.setAttribute("normal", new BufferAttribute(normals, 3));
  geometry.setIndex(new BufferAttribute(index, 1));
  if (looks) geometry.setAttribute(LOOKS_ATTRIBUTE, new BufferAttribute(looks, 2));
  return geometry;
}

const EVERYWHERE = new Sphere();

const drawnLine = (opacity: number) => new LineBasicMaterial({ transparent: true, opacity });

function clear(group: Group): void {
  for (const child of [...group.children]) {
    if (child instanceof Triangles || child instanceof LineSegments) (child.geometry as BufferGeometry).dispose();
    group.remove(child);
  }
}

/** A stage on a canvas; null without WebGL. */
export function createStage(canvas: HTMLCanvasElement): SolidStage | null {
  const context = canvas.getContext("webgl2", { alpha: true, antialias: false });
  if (!context) return null;
  const renderer = new WebGLRenderer({ canvas, context, alpha: true });
  renderer.setClearAlpha(0);
  const smoothly = createSmoothEdges(renderer);
  const space = new Space(),
    camera = new PerspectiveCamera((FIELD * 180) / Math.PI, 1, 1, 1000);
  camera.up.set(1, 0, 0);
  const world = new Group(),
    work = new Group(),
    chuck = new Group(),
    tool = new Group();
  const path = createPathStage(),
    chip = createChipStage();
  world.add(work, chuck, tool, chip.group, path.group);
  space.add(world);

  const surfaces = {
    steel: surface(28, 0x2a2a2a),
    residual: surface(8, 0x111111),
    gouge: surface(8, 0x111111),
    chuck: surface(12, 0x111111),
    jaw: surface(12, 0x111111),
    insert: surface(30, 0x222222),
    holder: surface(16, 0x1a1a1a),
  };
  const sections = { steel: hatched(-1, 1), residual: hatched(1, 1), gouge: hatched(-1, 1) };
  const lines = { work: drawnLine(0.55), parts: drawnLine(0.4) };

  /** Everything is in view; culling would walk all vertices. */
  const put = (group: Group, body: Triangles | LineSegments) => {
    body.frustumCulled = false;
    // Bodies are sorted by distance, which would walk all vertices again.
    (body.geometry as BufferGeometry).boundingSphere = EVERYWHERE;
    group.add(body);
  };
  const add = (group: Group, mesh: Mesh, material: Material) => {
    if (mesh.index.length > 0) put(group, new Triangles(geometryOf(mesh), material));
  };
  const addLines = (group: Group, edges: Float32Array, material: Material) => {
    if (edges.length === 0) return;
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(edges, 3));
    put(group, new LineSegments(geometry, material));
  };
  const setParts = (group: Group, parts: readonly DrawnPart[]) => {
    clear(group);
    for (const { role, mesh, edges } of parts) {
      add(group, mesh, surfaces[role].material);
      addLines(group, edges, lines.parts);
    }
  };

  let [canvasSize, fullRatio, share]: [Size, number, number] = [{ width: 1, height: 1 }, 1, 1];
  /** A smaller buffer, not a part of a large one: without a graphics card each frame copies the whole into the page. */
  const resize = () => renderer.setDrawingBufferSize(canvasSize.width, canvasSize.height, fullRatio * share);

  return {
    setShare(next) {
      share = next;
      resize();
    },
    setSize({ width, height }, below, ratio) {
      [canvasSize, fullRatio] = [{ width, height }, ratio];
      const seen = Math.max(1, height - below);
      camera.aspect = width / seen;
      camera.setViewOffset(width, seen, 0, 0, width, height);
      resize();
    },
    setColours(c) {
      const tones = [c.tone0, c.tone1, c.tone2, c.tone3, c.tone4, c.tone5, c.tone6];
      surfaces.steel.setSteel({ steel: c.turned, dark: c.steelDark, light: c.steelLight, line: c.line, tones });
      surfaces.residual.color.set(c.residual);
      surfaces.gouge.color.set(c.danger);
      const { chuck: body, jaw } = chuckTones(c);
      surfaces.chuck.color.set(body);
      surfaces.jaw.color.set(jaw);
      surfaces.insert.color.set(c.insert).lerp(new Color(c.holder), MUTED);
      surfaces.holder.color.set(c.holder);
      sections.steel.colours(c.material, c.hatch);
      sections.residual.colours(c.residual, new Color(c.residual).lerp(new Color(c.surface), PALE));
      sections.gouge.colours(c.danger, c.danger);
      for (const each of Object.values(lines)) each.color.set(c.line);
      path.setColours(c);
      chip.setColours(c.accent, c.surface);
    },
    setBodies(bodies) {
      clear(work);
      for (const { role, solid } of bodies) {
        add(work, solid.surface, surfaces[role].material);
        add(work, solid.section, sections[role].material);
        addLines(work, solid.edges, lines.work);
      }
    },
    setChuck: (parts) => setParts(chuck, parts),
    setTool: (parts) => setParts(tool, parts),
    placeTool(tip) {
      tool.visible = chip.group.visible = tip !== null;
      if (tip) {
        for (const each of [tool, chip.group]) each.position.set(tip.r, 0, tip.z);
      }
    },
    setChip: chip.set,
    setLines: path.set,
    setStep: path.runs,
    turnOver(down) {
      world.scale.x = down ? -1 : 1;
    },
    draw(orbit, size, reach) {
      camera.position.set(...eyeOf(orbit));
      camera.lookAt(...orbit.centre);
      camera.near = Math.max(orbit.distance / 50, orbit.distance - reach);
      camera.far = orbit.distance + reach;
      camera.updateProjectionMatrix();
      const pixel = pixelAt(orbit, size);
      for (const each of Object.values(sections)) each.pitch(HATCH * pixel);
      path.setPixel(pixel);
      if (share < 1) renderer.render(space, camera);
      else smoothly.draw(() => renderer.render(space, camera));
    },
    dispose() {
      for (const group of [work, chuck, tool]) clear(group);
      path.dispose();
      chip.dispose();
      for (const each of Object.values(lines)) each.dispose();
      for (const { material } of [...Object.values(surfaces), ...Object.values(sections)]) material.dispose();
      smoothly.dispose();
      renderer.dispose();
      // A browser has few contexts and drops the oldest for a new one, so an unused one is released at once.
      if (!canvas.isConnected) renderer.forceContextLoss();
    },
  };
}
