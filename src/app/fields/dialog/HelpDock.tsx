import type { ReactNode } from "react";
import { useMedia } from "../../base/use-media.ts";
import { holdDrawingDock, holdHelpDock, useDrawingDock, useHelpDock } from "./help-dock.ts";

/**
 * Centre of a workplace; its class says whether a help picture is docked, and whether a drawing is shown. A `:has()`
 * rule would be re-evaluated for the whole view with each node added to the picture.
 */
export function Centre({ children }: { readonly children: ReactNode }) {
  const docked = useHelpDock((d) => d.filled);
  const drawn = useDrawingDock((d) => d.filled);
  return (
    <div className={`centre${docked ? " docked" : ""}${drawn ? " drawn" : ""}`}>
      {children}
      <div className="drawing-dock" ref={holdDrawingDock} />
    </div>
  );
}

/** Pane next to the view for the help picture of the open prompt, where the screen has room. */
export function HelpDock() {
  const docked = useMedia("docked");
  return docked && <div className="help-dock" ref={holdHelpDock} />;
}
