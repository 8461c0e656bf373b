import { expose } from "comlink";
import { z } from "zod";
import { engine } from "./engine.ts";

z.config({ jitless: true });
expose(engine);
