import { createContext } from "react";
import type { FindingsHost } from "./host.ts";

/** The workplace that fixes findings, for dialogs that show their own; null outside of one. */
export const FindingsHostContext = createContext<FindingsHost | null>(null);
