import { expose } from "comlink";
import { z } from "zod/mini";
import { engine } from "./engine.ts";
import { wireOutcomes } from "./wire.ts";

z.config({ jitless: true });
wireOutcomes();
expose(engine);
