import { z } from "zod/mini";
import { usePlace, type WorkPlace } from "../place.ts";
import { useEditor } from "../store.ts";

/** Where the operator was in this browser tab: survives a reload, not the tab. */
const KEY = "turnwise/place";

const text = z.string().check(z.maxLength(500));
const place = z.object({
  work: text,
  section: z.enum(["prompts", "setup", "contour", "findings", "program"]),
  prompt: z.nullable(text),
  before: text,
});

/** Opens the prompt that was open before the page was loaded again, when the same work is open again. */
export function resumePlace(): void {
  try {
    const read = place.safeParse(JSON.parse(sessionStorage.getItem(KEY) ?? "null"));
    if (!read.success || read.data.work !== useEditor.getState().work) return;
    const { section, prompt, before } = read.data;
    usePlace.setState((p): WorkPlace => ({ ...p, section, prompt, before }));
  } catch {
    return;
  }
}

/** From now on the open prompt and section are noted for a reload. */
export function startKeepingPlace(): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  const write = () => {
    timer = undefined;
    const { section, prompt, before } = usePlace.getState();
    try {
      sessionStorage.setItem(KEY, JSON.stringify({ work: useEditor.getState().work ?? "", section, prompt, before }));
    } catch {
      return;
    }
  };
  const later = () => {
    timer ??= setTimeout(write);
  };
  const stops = [usePlace.subscribe(later), useEditor.subscribe((now, before) => now.work !== before.work && later())];
  return () => {
    clearTimeout(timer);
    stops.forEach((stop) => stop());
  };
}
