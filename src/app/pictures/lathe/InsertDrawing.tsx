import { useId, useMemo } from "react";
import { holderOutlines } from "../../../kernel/cutter/holder.ts";
import { insertOutline, isBar, tipDirection } from "../../../kernel/cutter/insert.ts";
import { CHORD } from "../../../kernel/tolerance.ts";
import type { Tool } from "../../../kernel/plan/tool.ts";
import type { Bounds } from "../../../view/camera.ts";
import { boundsOf, common, grownBounds, joined } from "../../../view/bounds.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { DrawnTool } from "./DrawnTool.tsx";
import "./lathe.css";
import { pageLength } from "../../base/unit.ts";

/** How much of the holder is drawn, in insert lengths: the head and the start of the shank. */
const BESIDE = 1.6;

/** Bounds of a tool without an outline. */
const BARE: Bounds = { left: -1, right: 1, low: -1, high: 1 };
/** The theoretical tip is the zero point of a tool. */
const TIP: Bounds = { left: 0, right: 0, low: 0, high: 0 };

/** Bounds of a tool's insert and the near end of its holder. */
export function heldBounds(tool: Tool): Bounds {
  const insert = boundsOf(insertOutline(tool, CHORD)) ?? BARE;
  const near = grownBounds(insert, BESIDE * Math.max(insert.right - insert.left, insert.high - insert.low));
  return common(joined(insert, boundsOf(holderOutlines(tool).flat())) ?? insert, near);
}

/** Lines across the drawing at a distance from the tip: the cutting depth of a blade, the far wall of the smallest bore. */
function limitLines(tool: Tool): (readonly ["x" | "z", number])[] {
  const { u, v } = tipDirection(tool.TO);
  return [
    ...(isBar(tool) && tool.CDX !== undefined
      ? [v === 0 ? (["z", -Math.sign(u) * tool.CDX] as const) : (["x", -Math.sign(v) * tool.CDX] as const)]
      : []),
    ...(tool.DMIN !== undefined && v > 0 ? [["x", -tool.DMIN] as const] : []),
  ];
}

/** A tool's insert, with holder if it has one, to scale: Z to the right, X up, a small cross at the theoretical tip. */
export function InsertDrawing({
  tool,
  width = 48,
  height = 48,
  span,
  whole = false,
}: {
  readonly tool: Tool;
  /** Pixels. */
  readonly width?: number;
  readonly height?: number;
  /**
   * Millimetres along the smaller side, to draw several tools in one scale; by default the insert fills the drawing.
   */
  readonly span?: number;
  /** Frames the holder too, not only the insert. */
  readonly whole?: boolean;
}) {
  const t = useTexts().lathe,
    id = useId();
  // The tip is outside the outline if the nose is round, far outside if the insert is turned away from its orientation.
  const box = useMemo(
    () => joined(whole ? heldBounds(tool) : boundsOf(insertOutline(tool, CHORD)), TIP) ?? BARE,
    [tool, whole],
  );
  const limits = whole ? limitLines(tool) : [];
  const wide = box.right - box.left,
    tall = box.high - box.low;
  const scale = span ? Math.min(width, height) / span : Math.min((width - 8) / wide, (height - 8) / tall);
  const x = width / 2 - ((box.left + box.right) / 2) * scale,
    y = height / 2 + ((box.low + box.high) / 2) * scale;
  return (
    <svg
      className="insert-drawing"
      role="img"
      aria-label={t.insert(String(tool.T))}
      width={pageLength(width)}
      height={pageLength(height)}
      viewBox={`0 0 ${width} ${height}`}
    >
      <clipPath id={id}>
        <rect width={width} height={height} />
      </clipPath>
      <g clipPath={`url(#${id})`}>
        <g transform={`matrix(${scale} 0 0 ${-scale} ${x} ${y})`}>
          <DrawnTool tool={tool} />
        </g>
        {whole && limits.length > 0 && (
          <path
            className="tool-limit"
            d={limits
              .map(([axis, at]) => (axis === "x" ? `M0 ${y - at * scale}H${width}` : `M${x + at * scale} 0V${height}`))
              .join("")}
          />
        )}
        <path className="insert-tip" d={`M${x - 3} ${y}H${x + 3}M${x} ${y - 3}V${y + 3}`} />
      </g>
    </svg>
  );
}
