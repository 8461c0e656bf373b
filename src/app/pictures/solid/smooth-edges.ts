import { SRGBColorSpace, Vector2, WebGLRenderTarget, type WebGLRenderer } from "three";

/** Samples of a pixel, as browsers take them for a canvas with smooth edges. */
const SAMPLES = 4;

/** Draws with smooth edges on a canvas that has none of its own. */
export interface SmoothEdges {
  readonly draw: (render: () => void) => void;
  readonly dispose: () => void;
}

/**
 * A canvas with smooth edges keeps them for every frame, and without a graphics card they take most of its time. So the
 * samples are a buffer of their own, used for the frames that need them.
 */
export function createSmoothEdges(renderer: WebGLRenderer): SmoothEdges {
  const gl = renderer.getContext() as WebGL2RenderingContext,
    size = new Vector2();
  const target = new WebGLRenderTarget(1, 1, { samples: SAMPLES, resolveDepthBuffer: false });
  // Only into a target of this kind does the library draw the colours of the screen, without another conversion.
  Object.assign(target, { isXRRenderTarget: true });
  Object.assign(target.texture, { colorSpace: SRGBColorSpace, internalFormat: "RGBA8" });
  return {
    draw(render) {
      const { x, y } = renderer.getDrawingBufferSize(size);
      target.setSize(x, y);
      renderer.setRenderTarget(target);
      render();
      renderer.setRenderTarget(null);
      const { __webglFramebuffer: drawn } = renderer.properties.get(target) as {
        readonly __webglFramebuffer: WebGLFramebuffer;
      };
      renderer.state.bindFramebuffer(gl.READ_FRAMEBUFFER, drawn);
      gl.blitFramebuffer(0, 0, x, y, 0, 0, x, y, gl.COLOR_BUFFER_BIT, gl.NEAREST);
      renderer.state.bindFramebuffer(gl.READ_FRAMEBUFFER, null);
    },
    dispose: () => target.dispose(),
  };
}
