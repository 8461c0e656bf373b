import { partSegment } from "../../kernel/plane/plane.ts";
import { segmentData } from "../path.ts";
import { wayOf, type MillMotion } from "../../kernel/plane/mill-motion.ts";

/** One motion as path data of the plane. */
export const planeMotionData = (m: MillMotion): string => segmentData([partSegment(wayOf(m))]);
