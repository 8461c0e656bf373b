import { createRoot } from "react-dom/client";
import { clock } from "../../src/app/base/clock.ts";
import { LatheView } from "../../src/app/pictures/lathe/LatheView.tsx";
import { createPlaybackStore } from "../../src/app/calculation/playback-store.ts";
import { followAppearance } from "../../src/app/base/settings/appearance.ts";
import { fetchTexts } from "../../src/app/base/settings/loaded-texts.ts";
import { useSettings } from "../../src/app/base/settings/settings.ts";
import "../../src/app/base/styles/base.css";
import { exampleResult } from "./hand-made-run.ts";

/* The lathe view alone, on a run made by hand: `?end` starts at the end, `?fault` cuts into the part, `?many` has 5,000 moves. */
const asked = new URLSearchParams(location.search);
followAppearance();
const playback = createPlaybackStore(clock);
const root = document.getElementById("root");
const result = exampleResult({ fault: asked.has("fault"), many: asked.has("many") });
void fetchTexts(useSettings.getState().language).then(() => {
  if (root)
    createRoot(root).render(<LatheView result={result} dimmed={asked.has("dim")} playback={playback} clock={clock} />);
});
if (asked.has("end")) setTimeout(() => playback.dispatch({ do: "last" }), 100);
if (asked.has("at"))
  setTimeout(() => playback.dispatch({ do: "seek", position: { step: Number(asked.get("at")), fraction: 0.5 } }), 100);
