import type { ReactNode } from "react";
import { useMedia } from "../../base/use-media.ts";
import { holdHelpDock, useHelpDock } from "./help-dock.ts";

/**
 * Centre of a workplace; its class says whether a help picture is docked. A `:has()` rule would be re-evaluated for the
 * whole view with each node added to the picture.
 */
export function Centre({ children }: { readonly children: ReactNode }) {
  const docked = useHelpDock((d) => d.filled);
  return <div className={docked ? "centre docked" : "centre"}>{children}</div>;
}

/** Pane next to the view for the help picture of the open prompt, where the screen has room. */
export function HelpDock() {
  const docked = useMedia("docked");
  return docked && <div className="help-dock" ref={holdHelpDock} />;
}
