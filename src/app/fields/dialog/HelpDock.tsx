import type { ReactNode } from "react";
import { useMedia } from "../../base/use-media.ts";
import { holdHelpDock, useHelpDock } from "./help-dock.ts";

/**
 * The middle of a workplace; its class says whether a help picture stands beside the view. A style rule that asks what
 * it has inside would be looked up for all of the view with each node that comes into the picture.
 */
export function Centre({ children }: { readonly children: ReactNode }) {
  const docked = useHelpDock((d) => d.filled);
  return <div className={docked ? "centre docked" : "centre"}>{children}</div>;
}

/** The pane beside the view that the help picture of the open prompt goes to, where the screen has room for one. */
export function HelpDock() {
  const docked = useMedia("docked");
  return docked && <div className="help-dock" ref={holdHelpDock} />;
}
