/* The part of this feature that the first screen needs. */

export { HandedLine, IncomingWork } from "./HandedParts.tsx";
