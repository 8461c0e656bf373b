import { hideOwn } from "../own/own-place.ts";
import { usePlace } from "../place.ts";
import { open, useEditor } from "../store.ts";
import { hideTools } from "../tools/tool-place.ts";
import { showElsewhere } from "../saving/elsewhere.ts";
import { hideWhich } from "../which/which-place.ts";
import { hideWorks, useWorksPlace } from "../works/works-place.ts";

/** Shows the start page. What was open stays on the device, and undo opens it again. */
export function goHome(): void {
  hideTools();
  hideOwn();
  hideWhich();
  hideWorks();
  showElsewhere(null);
  usePlace.setState({ section: "prompts", prompt: null, field: null });
  if (useEditor.getState().work !== null) open(null, null);
}

/** Shows the list of all works, in place of the start page. */
export function goToWorks(): void {
  goHome();
  useWorksPlace.setState({ shown: true });
}
