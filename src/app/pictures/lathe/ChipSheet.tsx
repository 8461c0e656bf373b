import { useEffect, useRef } from "react";
import { sameChip, type Chip } from "../../../sim/chip/chip.ts";
import { chipMeasure, drawnChip } from "../../../view/cutting-tool/chip-drawing.ts";
import { useLengths } from "../../calculation/lengths.ts";
import type { Camera } from "../../../view/camera.ts";
import type { PlayedScene } from "../../calculation/moving.ts";
import type { Viewport } from "./viewport.ts";

/** Half size of the cross at the theoretical tip, pixels, and the scale from which it is shown, pixels per mm. */
const CROSS = 4;
const NEAR = 40;

/**
 * The chip and the cutting edge, over the tool. Its shapes are relative to the tip and change only with the chip, so
 * not during an even cut. Its numbers change no faster than they can be read.
 */
export function ChipSheet({
  viewport,
  moving: { chipAt, playback },
}: {
  readonly viewport: Viewport;
  readonly moving: PlayedScene;
}) {
  const sheet = useRef<SVGSVGElement>(null),
    lengths = useLengths();
  useEffect(() => {
    const element = sheet.current;
    const [world, area, edge, glow, cross, line] = [
      "g",
      ".chip-area",
      ".chip-edge",
      ".chip-glow",
      ".chip-tip",
      ".chip-measure",
    ].map((part) => element?.querySelector(part));
    const text = element?.querySelector("text");
    if (!element || !text) return undefined;
    let drawn: Chip | null = null,
      written: Chip | null = null;
    const write = () => {
      written = drawn;
      const { scale, xUp } = viewport.drawn(),
        measure = drawn && chipMeasure(drawn, scale, xUp);
      line?.setAttribute("d", measure?.line ?? "");
      text.textContent =
        drawn && measure ? `h ${lengths.fixed(drawn.thickest.size, 3)} · b ${lengths.fixed(drawn.width, 2)}` : "";
      if (!measure) return;
      text.setAttribute("x", String(measure.text.x));
      text.setAttribute("y", String(measure.text.y));
      text.setAttribute("text-anchor", measure.anchor);
    };
    const place = () => {
      const chip = chipAt(playback.shown());
      if (sameChip(chip, drawn)) return;
      drawn = chip;
      const shapes = drawnChip(chip);
      area?.setAttribute("d", shapes.area);
      edge?.setAttribute("d", shapes.edge);
      glow?.setAttribute("d", shapes.edge);
      if (!chip) write();
    };
    const read = () => {
      if (written !== drawn) write();
    };
    let camera: Camera | null = null;
    const look = () => {
      if (viewport.drawn() === camera) return;
      camera = viewport.drawn();
      const { scale, xUp } = camera;
      world?.setAttribute("transform", `scale(${scale} ${xUp ? -scale : scale})`);
      cross?.setAttribute("d", scale < NEAR ? "" : `M${-CROSS} 0H${CROSS}M0 ${-CROSS}V${CROSS}`);
      place();
      write();
    };
    look();
    const ends = [viewport.subscribe(look), playback.subscribe(place), playback.subscribeReader(read)];
    return () => ends.forEach((end) => end());
  }, [viewport, chipAt, playback, lengths]);
  return (
    <svg ref={sheet} className="chip-sheet" viewBox="0 0 1 1" aria-hidden="true">
      <g>
        <path className="chip-area" />
        <path className="chip-glow" />
        <path className="chip-edge" />
      </g>
      <path className="chip-tip" />
      <path className="chip-measure" />
      <text className="number" />
    </svg>
  );
}
