import { expose } from "comlink";
import { z } from "zod/mini";
import { engine } from "./engine.ts";

z.config({ jitless: true });
expose(engine);
