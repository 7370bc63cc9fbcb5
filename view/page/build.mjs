// Bundles src into dist/report.js and dist/report.css, which the program embeds. Run: npm ci && npm run build
import { build } from 'esbuild';

await build({
  entryPoints: ['src/report.js'],
  bundle: true,
  minify: true,
  charset: 'ascii',
  format: 'iife',
  target: ['chrome100', 'firefox113', 'safari16.4'],
  legalComments: 'eof',
  outdir: 'dist',
});
