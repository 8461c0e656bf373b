import { useMedia } from "../use-media.ts";
import { holdHelpDock } from "./help-dock.ts";

/** The pane beside the view that the help picture of the open prompt goes to, where the screen has room for one. */
export function HelpDock() {
  const docked = useMedia("docked");
  return docked && <div className="help-dock" ref={holdHelpDock} />;
}
