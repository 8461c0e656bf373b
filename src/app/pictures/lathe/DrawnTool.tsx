import { memo, useMemo } from "react";
import type { Tool } from "../../../kernel/plan/tool.ts";
import { toolShapes } from "../../../view/cutting-tool/drawing.ts";

/** A tool in part space, relative to its tip: holder, insert in its pocket, and what holds it. */
export const DrawnTool = memo(function DrawnTool({ tool }: { readonly tool: Tool }) {
  const shapes = useMemo(() => toolShapes(tool), [tool]);
  return shapes.map(({ role, d }, i) => <path key={i} className={`shape-${role}`} d={d} />);
});
