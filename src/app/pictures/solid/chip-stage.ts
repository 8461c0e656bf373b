import { BufferAttribute, BufferGeometry, Color, DoubleSide, Group, Mesh as Triangles, MeshBasicMaterial } from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { sameChip, type Chip } from "../../../sim/chip/chip.ts";
import { chipInSpace } from "../../../view/solid/chip.ts";
import { piecesGeometry, wideLines } from "./lines.ts";

/** Share of accent in the chip's colour, as in the section; width of the cutting edge, pixels. */
const ACCENT = 0.38;
const EDGE = 3;

/** The current chip and its cutting edge, relative to the tip. */
export interface ChipStage {
  readonly group: Group;
  readonly set: (chip: Chip | null) => void;
  readonly setColours: (accent: string, surface: string) => void;
  readonly dispose: () => void;
}

/** Uses no graphics memory while no chip is cut. */
export function createChipStage(): ChipStage {
  const group = new Group();
  const before = { polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -1, side: DoubleSide } as const;
  const area = new MeshBasicMaterial(before),
    edge = new LineMaterial({ linewidth: EDGE, ...before });
  let drawn: Chip | null = null;
  const clear = () => {
    for (const child of [...group.children]) {
      if (child instanceof Triangles) (child.geometry as BufferGeometry).dispose();
      group.remove(child);
    }
  };
  return {
    group,
    set(chip) {
      if (sameChip(chip, drawn)) return;
      drawn = chip;
      clear();
      if (!chip) return;
      const { positions, index, contact } = chipInSpace(chip),
        filled = new BufferGeometry();
      filled.setAttribute("position", new BufferAttribute(positions, 3));
      filled.setIndex(new BufferAttribute(index, 1));
      group.add(new Triangles(filled, area));
      if (contact.length === 0) return;
      group.add(wideLines(piecesGeometry(contact), edge));
    },
    setColours(accent, surface) {
      edge.color.set(accent);
      area.color.copy(new Color(surface).lerp(new Color(accent), ACCENT));
    },
    dispose() {
      clear();
      area.dispose();
      edge.dispose();
    },
  };
}
