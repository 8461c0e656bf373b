import { useEffect, useRef } from "react";
import { toScreen, type Place } from "../../../view/camera.ts";
import { pageLength } from "../../base/unit.ts";
import type { MovingAnchor } from "./moving-anchor.ts";
import type { Viewport } from "./viewport.ts";

const CORNER: Place = { x: 0, y: 0 };

/**
 * Moves its content with the tip: an outer element follows the camera, an inner one the tip, by transforms that cost no
 * layout and no painting.
 */
export function TipCarrier({
  viewport,
  carrying,
  children,
}: {
  readonly viewport: Viewport;
  readonly carrying: MovingAnchor;
  readonly children: React.ReactNode;
}) {
  const world = useRef<HTMLDivElement>(null),
    carrier = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const carried = carrier.current,
      around = world.current;
    if (!carried || !around) return undefined;
    let drawn = viewport.drawn();
    const gliding = carrying.carry(carried, (tip) => {
      const { x, y } = toScreen({ ...drawn, zero: CORNER }, tip);
      return `translate(${pageLength(x)}, ${pageLength(y)})`;
    });
    const look = () => {
      const { zero, scale } = viewport.get(),
        before = drawn;
      drawn = viewport.drawn();
      const grown = scale / drawn.scale;
      around.style.transform = `translate(${pageLength(zero.x)}, ${pageLength(zero.y)})${grown === 1 ? "" : ` scale(${grown})`}`;
      if (drawn.scale !== before.scale || drawn.xUp !== before.xUp) gliding.recompute();
    };
    look();
    const deaf = viewport.subscribe(look);
    return () => {
      deaf();
      gliding.end();
    };
  }, [viewport, carrying]);
  return (
    <div ref={world} className="tool-world">
      <div ref={carrier} className="tool-carrier">
        {children}
      </div>
    </div>
  );
}
