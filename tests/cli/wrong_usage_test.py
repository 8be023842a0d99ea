#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""What people type by mistake. Each row is answered by status 2 or 4 and one or two lines, which name what was meant or what is wrong, once;
no file is made or changed."""
import re
import shutil
import unittest

import support
from support import MODELS, VALID, Folder, run

# Arguments, status, words of the answer. Status 2: the command line is wrong. Status 4: a file is not what it should be.
COMMANDS = [
    ("certfy a.off", 2, "unknown command: certfy; did you mean certify?"),
    ("Certify a.off", 2, "did you mean certify?"),
    ("explain-cert c", 2, "did you mean explain-certificate?"),
    ("frobnicate", 2, "unknown command: frobnicate\n"),
    ("a.off", 2, "unknown command: a.off; to decide about this file: veritope certify a.off"),
    ("help certfy", 2, "did you mean certify?"),
    ("help certify info", 2, "help takes one command: veritope help certify"),
    ("--hlep", 2, "veritope has no option --hlep; did you mean --help?"),
    ("-v", 2, "veritope has no option -v; did you mean -V?"),
    ("--tsv -", 2, "veritope has no option --tsv; it is one of certify"),
    ("--", 2, "a command is needed: veritope certify FILE"),
]
OPTIONS = [
    ("dms", 2, "dms needs one of: eval, fit, make, domain, xray, refine, boundary, edit, iso"),
    ("dms evla m.vdms p", 2, "dms has no evla, but: eval, fit, make, domain, xray, refine, boundary, edit, iso; did you mean eval?"),
    ("dms eval --exat m.vdms p", 2, "dms eval has no option --exat; did you mean --exact?"),
    ("dms eval m.vdms p --degree=2", 2, "dms eval has no option --degree; it is one of dms fit and dms make"),
    ("dms eval m.vdms p --gradient", 2, "--gradient requires --json"),
    ("dms eval - p", 2, "M is a file, not standard input"),
    ("dms eval m.vdms", 2, "veritope dms eval M POINTS takes 2 files, and there is 1"),
    ("dms iso - --attribute a --level 0 --within 1 -o f.off", 2, "M is a file, not standard input"),
    ("dms iso m.vdms --level 0 --within 1 -o f.off", 2, "--attribute A is required"),
    ("dms iso m.vdms --attribute a --within 1 -o f.off", 2, "--level C is required"),
    ("dms iso m.vdms --attribute a --level 0 -o f.off", 2, "--within E is required"),
    ("dms iso m.vdms --attribute a --level 0 --within 0 -o f.off", 2, "--within: must be a number > 0"),
    ("dms iso m.vdms --attribute a --level x --within 1 -o f.off", 2, "--level: must be a number, not x"),
    ("dms iso m.vdms --attribute a --level 0 --within 1", 2, "-o F is required"),
    ("dms iso m.vdms --attribute a --level 0 --within 1 -o f.stl", 2, "must end in .off, .ply or .obj, not f.stl"),
    ("dms iso m.vdms --attribute a --level 0 --within 1 -o f.off --space here", 2, "must be domain or solid, not here"),
    ("dms domain p -o d.vdms --max-volume 0", 2, "--max-volume: must be a positive number, not 0"),
    ("dms domain p -o d.vdms --max-radius-edge 1/2", 2, "--max-radius-edge: must be a number of at least 1, not 1/2"),
    ("dms domain p -o d.vdms --max-points 9", 2, "--max-points needs --max-volume or --max-radius-edge"),
    ("dms fit p -o f.vdms --degree 2", 2, "--domain D.vdms is required, the identity on a domain, or --auto"),
    ("dms fit p -o f.vdms --degree 2 --auto --domain d.vdms", 2, "--auto makes the domain, so it excludes --domain"),
    ("dms make d.vdms --degree 2", 2, "-o OUT.vdms is required"),
    ("dms make d.vdms -o x.vdms", 2, "--degree N is required"),
    ("dms make d.vdms -o x.vdms --degree 10", 2, "--degree: must be a number from 1 to 9, not 10"),
    ("dms make d.vdms -o x.vdms --degree 2 --clouds none", 2, "must be collapsed, or a number R >= 0, or R:SEED, not none"),
    ("dms make d.vdms -o x.vdms --degree 2 --control paper", 2, "must be greville or edges, not paper"),
    ("certify --quite a.off", 2, "certify has no option --quite; did you mean --quiet?"),
    ("certify --cert c a.off", 2, "did you mean --certificate?"),
    ("certify -x a.off", 2, "certify has no option -x\n"),
    ("certify --regular --collar a.itd", 2, "--regular is about cells of volumes, and --collar about boundary faces alone"),
    ("certify --to stl a.off", 2, "certify has no option --to; it is one of convert"),
    ("info -q a.off", 2, "info has no option -q; it is one of certify and cover"),
    ("convert --what a.off out.stl", 2, "it is one of cover"),
    ("corpus --onyl orient2d", 2, "corpus has no option --onyl"),
    ("certify --json", 2, "--json needs a value: --json F"),
    ("certify a.off -q -q --json", 2, "--json needs a value: --json F"),
    ("certify --certificate= a.off", 2, "--certificate needs a value: --certificate F"),
    ("certify a.off --json ''", 2, "--json: needs a name"),
    ("certify models --glob ''", 2, "--glob: needs a PATTERN"),
    ("certify a.off --json r --json s", 2, "--json is given 2 times"),
    ("certify a.off --no-check=maybe", 2, "--no-check takes no value"),
    ("certify --glob *.off a.off", 2, "no folder is given"),
    ("certify --picture p.png a.off b.off", 2, "--picture takes exactly one input"),
    ("certify --picture p.png models", 2, "not a folder"),
    ("certify --json - --tsv - a.off", 2, "--json and --tsv would both write standard output"),
    ("cover cube.itd --eps 1 -o o.vtu", 2, "--eps requires --sweep"),
    ("cover cube.itd --sweep 1 --what boxes", 2, "--what excludes --sweep"),
    ("convert --chord 1 a.off out.stl", 2, "--chord is for splines"),
    ("convert --float a.off out.obj", 2, "--float is for binary PLY"),
]
VALUES = [
    ("certify --format stpl a.off", 2, "did you mean stl?"),
    ("certify --max-faces 1,000 a.off", 2, "not 1,000 (digits only)"),
    ("certify --max-faces -1 a.off", 2, "--max-faces: must be a number from 0 to 1073741823, not -1"),
    ("certify --max-faces 99999999999999999999 a.off", 2, "not 99999999999999999999\n"),
    ("certify --jobs a.off", 2, "--jobs: must be a number from 1 to 1024, not a.off"),
    ("certify --tolerance 0,1 cube.itd", 2, "not 0,1 (a decimal comma?)"),
    ("certify --tolerance nan cube.itd", 2, "must be a length from 1e-300 to 1e300, not nan"),
    ("certify --orient keap cube.itd", 2, "must be auto or keep, not keap; did you mean keep?"),
    ("certify --picture p.jpg a.off", 2, "--picture writes .png, .ply, .vtu and .gltf, not p.jpg"),
    ("cover cube.itd --what coller -o o.vtu", 2, "did you mean collar?"),
    ("cover cube.itd -o o.xyz", 2, "the name must end in .vtu, .obj, .ply, .off or .stl"),
    ("cover cube.itd --sweep two", 2, "--sweep: must be a number from 0 to 20, not two"),
    ("convert --to objj a.off o", 2, "did you mean obj?"),
    ("convert --to step a.off o", 2, "--to must be stl, stl-ascii, obj, ply, ply-ascii, ply-be or off, not step"),
    ("convert a.off o.itd", 2, "the name o.itd does not end in stl, obj, ply or off, the formats for a mesh; --to chooses"),
    ("convert cube.itd o.stl", 2, "the name o.stl does not end in itd, g2, vjson, vtu, obj or gltf, the formats for splines"),
    ("convert --pn cube.itd o.vjson", 2, "--pn is for meshes"),
    ("convert --pn --faces a.off o.vjson", 2, "--pn is for meshes"),
    ("convert --pn a.off o.stl", 2, "the name o.stl does not end in itd, g2, vjson, vtu, obj or gltf, the formats for splines"),
    ("convert --weld 0 cube.itd o.vjson", 2, "--weld: must be over 0, not 0"),
    ("convert --weld -1e-9 cube.itd o.vjson", 2, "--weld: must be over 0, not -1e-9"),
    ("convert --weld 1e-9mm cube.itd o.vjson", 2, "--weld: needs a decimal, fraction or hexadecimal number, not 1e-9mm"),
    ("convert --weld nan cube.itd o.vjson", 2, "--weld: needs a decimal, fraction or hexadecimal number, not nan"),
    ("convert --weld 1e-9 a.off o.off", 2, "--weld is for spline volumes"),
    ("convert --pn --weld 1e-9 a.off o.vjson", 2, "--pn is for meshes"),
    ("convert --json r cube.itd o.vjson", 2, "--json requires --weld"),
    ("convert --weld 1e-9 cube.itd o.vjson", 4, "cube.itd: entity 0: a surface, not a volume (--weld is for files of volumes only)"),
    ("intersect cube.itd cube.itd -o c.txt", 2, "the name must end in .json or .vtu"),
    ("intersect --gap 1mm cube.itd cube.itd", 2, "not 1mm"),
    ("classify --decimals rounded a.off a.off", 2, "--decimals: must be nearest or exact, not rounded"),
    ("boolean 'A |' A=a.off -o e.json", 2, "EXPR: column 4: an operand expected, but there is the end"),
    ("boolean 'A & B' A=a.off -o e.json", 2, "EXPR: column 5: the name B has no file: write B=FILE"),
    ("boolean A A=a.off -o e.off", 2, "the name e.off does not end in .json"),
    ("boolean A A=a.off -o e.json --box 0,0,0,1,1", 2, "--box: needs six bounds X0,Y0,Z0,X1,Y1,Z1, and there are 5"),
    ("cage bxo -o c.vjson", 2, "KIND: must be box, radial, hull, split or fit, not bxo; did you mean box?"),
    ("cage box --min 0,0 --max 1,1,1 -o c.vjson", 2, "--min: needs three numbers X,Y,Z, not 0,0"),
    ("cage box --min 0,0,x --max 1,1,1 -o c.vjson", 2, "--min: needs decimals, fractions or hexadecimal numbers X,Y,Z, and has 'x'"),
    ("cage box --min 0,0,0 --max 1,1,1 --degrees 1,16,1 -o c.vjson", 2, "--degrees: needs three numbers P,Q,R from 1 to 15, not 1,16,1"),
    ("cage box --min 0,0,0 --max 1,1,1 --spans 1,1,0 -o c.vjson", 2, "--spans: needs three numbers A,B,C from 1 to 4096, not 1,1,0"),
    ("cage box --around a.off --margin=-1 -o c.vjson", 2, "--margin: must not be negative, and is -1"),
    ("cage hull --around a.off --margin 0 -o c.vjson", 2, "--margin of a hull must be positive"),
    ("cage radial --outer x --height 0,1 -o c.vjson", 2, "--outer: needs a decimal, fraction or hexadecimal number, not x"),
    ("cage split --of c.vjson --at x=1 -o d.vjson", 2, "--at: needs an axis and a parameter, such as u=1/2, not x=1"),
    ("micro --cage c.vjson --tile ball --counts 1,1,1 -o c.vmicro", 2, "--tile: needs jack, frame, branch, curves3 or jack-surfaces, such as"),
    ("micro --cage c.vjson --tile jack,size=1 --counts 1,1,1 -o c.vmicro", 2, "--tile: has no key size; a jack has node, cap and degree"),
    ("micro --cage c.vjson --tile jack,cap=1/2 --counts 1,1,1 -o c.vmicro", 2, "--tile: is not a tile: cap = 1/2 of a jack is not between 0 and 1/2"),
    ("micro --cage c.vjson --tile jack --counts 1,0,1 -o c.vmicro", 2, "--counts: needs three numbers K,M,N from 1, or such numbers for each volume, as in 2,3,4/2,3,1, not 1,0,1"),
    ("micro --cage c.vjson --tile jack --counts 1,1,1/ -o c.vmicro", 2, "--counts: needs three numbers K,M,N from 1, or such"),
    ("micro --cage c.vjson --tile jack --counts 1,1,4/1,1,4 --double w=2 -o c.vmicro", 2, "--double needs one K,M,N for all volumes"),
    ("micro --cage c.vjson --tile jack --counts 1,1,1 --thickness q -o c.vmicro", 2, "--thickness: is not a formula: column 1:"),
    ("micro --cage c.vjson --tile jack --counts 1,1,1 --material a -o c.vmicro", 2, "--material: needs NAME=EXPR, not a"),
    ("micro --cage c.vjson --tile jack --counts 1,1,1 --material a=1 --material a=2 -o c.vmicro", 2, "--material: names a twice"),
    ("cage split --of c.vjson --at u=1 --open w2 -o d.vjson", 2, "--open: needs a face, u0, u1, v0, v1, w0 or w1, not w2"),
    ("inspect --pair 0 cube.itd", 2, "--pair: needs the numbers of two cells A,B, not 0"),
    ("inspect --pair 0,-1 cube.itd", 2, "not 0,-1"),
    ("chain --origin 0,0 a.off", 2, "--origin: needs three numbers X,Y,Z or auto, not 0,0"),
    ("chain --origin 1,2,x a.off", 2, "--origin: needs three decimals, fractions or hexadecimal numbers X,Y,Z, and has 'x'"),
    ("classify --origin auto a.off note.txt", 2, "--origin requires --by normal or literal"),
    ("classify --by litteral a.off note.txt", 2, "--by: must be service, normal or literal, not litteral; did you mean literal?"),
    ("render a.off -o p.jpg", 2, "the name p.jpg does not end in .png, .vtu, .gltf or .obj"),
    ("render a.off -o .obj", 2, "the name .obj does not end in"),
    ("render a.off -o p.gltf --size 640,480", 2, "--size is for .png"),
    ("render a.off -o p.obj --view 1,2,3", 2, "--view is for .png"),
    ("render a.off -o p.vtu --grid 3", 2, "--grid is for .png"),
    ("render a.off -o p.vtu --bounds 0,0,0,1,1,1", 2, "--bounds is for .png"),
    ("render a.off -o p.vtu --chord 1", 2, "--chord is for .png, .gltf and .obj"),
    ("render a.off -o p.png --grid 3 --nets", 2, "--grid shows the solid, and --nets its cells"),
    ("render a.off -o p.png --bounds 0,0,0,1,1,1 --explode 1", 2, "--bounds shows the solid, and --explode its cells"),
    ("render a.off -o p.png --explode=-1", 2, "--explode: needs a number from 0 to 1000000, not -1"),
    ("render a.off -o p.png --explode 1000001", 2, "--explode: needs a number from 0 to 1000000, not 1000001"),
    ("render a.off -o p.png --explode inf", 2, "--explode: needs a number from 0 to 1000000, not inf"),
    ("render a.off -o p.png --explode nan", 2, "--explode: needs a number from 0 to 1000000, not nan"),
    ("render a.off -o p.png --explode 1", 2, "--explode is for files of volumes in space; a.off: it is a mesh"),
    ("render a.off -o p.png --nets", 2, "--nets is for files of volumes in space; a.off: it is a mesh"),
    ("render a.off -o p.png --size 640", 2, "--size: needs two sides W,H from 64 to 8192, not 640"),
    ("render a.off -o p.png --size 640,63", 2, "--size: needs two sides W,H from 64 to 8192, not 640,63"),
    ("render a.off -o p.png --view 0,0,0", 2, "--view: is no direction: 0,0,0"),
    ("render a.off -o p.png --mode ray --attribute a", 2, "--mode: must be xray, volume, slice or iso, not ray"),
    ("render a.off -o p.png --mode xray", 2, "--attribute A is required with --mode"),
    ("render a.off -o p.png --mode iso --attribute a", 2, "--level C is required with --mode iso"),
    ("render a.off -o p.png --mode iso --attribute a --level x", 2, "--level: must be a number, not x"),
    ("render a.off -o p.png --mode iso --attribute a --level 1 --within 0", 2, "--within: must be a number > 0"),
    ("render a.off -o p.png --mode xray --attribute a --space solid", 2, "--space: pictures of mode xray are of the domain"),
    ("render a.off -o p.png --space solid --space solid", 2, "--space is given 2 times"),
    ("render a.off -o p.png --space here", 2, "--space: must be domain or solid, not here"),
    ("render a.off -o p.png --isolines 3", 2, "--isolines needs --mode"),
    ("render a.off -o p.png --mode xray --attribute a --transfer 0:1,1,1,1", 2, "--transfer is not for this mode"),
    ("render a.off -o p.png --mode xray --attribute a", 2, "--mode is for simplex-spline solids, and a.off is none"),
    ("render a.off -o p.png --attribute a", 2, "--attribute is for simplex-spline solids, and a.off is none"),
    ("render a.off -o p.png --view 1,2", 2, "--view: needs three numbers X,Y,Z, not 1,2"),
    ("render a.off -o p.png --grid 1025", 2, "--grid: must be a number from 1 to 1024, not 1025"),
    ("render a.off -o p.png --grid 0", 2, "--grid: must be a number from 1 to 1024, not 0"),
    ("render a.off -o p.png --bounds 0,0,0,1,1", 2, "--bounds: needs six bounds X0,Y0,Z0,X1,Y1,Z1, and there are 5"),
    ("render a.off -o p.png --bounds 0,0,0,1,1,0", 2, "--bounds: has no interior: 0,0,0,1,1,0"),
    ("project '0 0 0' cube.itd", 2, "POINT has the coordinate '0 0 0', not a decimal, fraction or hexadecimal number; write x,y,z"),
    ("project 0,0,x cube.itd", 2, "POINT has the coordinate 'x'"),
    ("project 1/0,0,0 cube.itd", 2, "which is not finite"),
    ("project cube.itd 0,0,0", 2, "POINT comes first, and cube.itd is a file: veritope project x,y,z cube.itd"),
    ("project 0,0 cube.itd", 4, "POINT has 2 coordinates, and entity 0 has 3"),
    ("project 1,5,2,5,0 cube.itd", 4, "POINT has 5 coordinates, and entity 0 has 3 (decimal commas?)"),
    ("explain M10", 2, "there is no rule M10; the rules are M1 to M9"),
    ("explain side-opne", 2, "did you mean side-open?"),
    ("explain bondary", 2, "did you mean boundary?"),
    ("explain ''", 2, "RULE must not be empty"),
    ("predicate orient3 cases", 2, "there is no predicate orient3; did you mean orient3d?"),
    ("predicate turnaround cases", 2, "there is no predicate turnaround; veritope selftest --verbose lists all"),
    ("predicate cases orient2d", 2, "comes before FILE; cases is a file: veritope predicate NAME cases"),
    ("selftest --cases 1e3", 2, "--cases: must be a number from 1 to 2^64 - 1, not 1e3"),
]
COUNTS = [
    ("certify", 2, "FILE is required: veritope certify FILE..."),
    ("convert a.off", 2, "OUT is required: veritope convert IN OUT"),
    ("convert a.off b.stl c.stl", 2, "the argument c.stl is one too many: veritope convert IN OUT"),
    ("intersect cube.itd", 2, "veritope intersect A B takes 2 files, and there is 1"),
    ("intersect cube.itd cube.itd cube.itd", 2, "and there are 3"),
    ("classify a.off", 2, "veritope classify MODEL POINTS takes 2 files, and there is 1"),
    ("boolean", 2, "EXPR [NAME=FILE] is required"),
    ("build -o b.vjson", 2, "TREE is required: veritope build TREE"),
    ("micro --tile jack --counts 1,1,1 -o c.vmicro", 2, "--cage is required, a spline file of volumes"),
    ("micro --cage c.vjson --counts 1,1,1 -o c.vmicro", 2, "--tile is required, such as jack"),
    ("micro --cage c.vjson --tile jack -o c.vmicro", 2, "--counts is required, such as 10,10,10"),
    ("micro --cage c.vjson --tile jack --counts 1,1,1", 2, "-o OUT.vmicro is required, the file of the microstructure"),
    ("micro --cage c.vjson --tile jack --counts 1,1,1 -o c.vjson", 2, "the name c.vjson does not end in .vmicro"),
    ("cage -o c.vjson", 2, "KIND is required: veritope cage KIND"),
    ("cage box -o c.vjson", 2, "box needs --around M, or --min and --max"),
    ("cage box --min 0,0,0 -o c.vjson", 2, "box needs --around M, or --min and --max"),
    ("cage box --around a.off --min 0,0,0 -o c.vjson", 2, "--around excludes --min and --max"),
    ("cage box --inner 1 -o c.vjson", 2, "--inner is for radial, not for box"),
    ("cage radial --around a.off --spans 1,1,1 -o c.vjson", 2, "--spans is for box, hull and fit, not for radial"),
    ("cage hull -o c.vjson", 2, "hull needs --around M"),
    ("cage radial --outer 1 -o c.vjson", 2, "radial needs --around M, or --outer and --height"),
    ("cage box --min 0,0,0 --max 1,1,1 --margin 1 -o c.vjson", 2, "--margin needs --around"),
    ("cage split --at u=1 -o c.vjson", 2, "split needs --of C.vjson, the cage to be split"),
    ("cage split --of c.vjson -o d.vjson", 2, "split needs --at, such as --at u=1/2"),
    ("cage split --of c.vjson --at u=1 --open w1 -o d.vjson", 2, "--open needs --from, and --low or --high"),
    ("cage split --of c.vjson --at u=1 --from 1 -o d.vjson", 2, "--from, --low and --high need --open"),
    ("cage box --around - -o c.vjson", 2, "- is not read: the model needs a file"),
    ("boolean A a.off -o e.json", 2, "write NAME=FILE, not a.off"),
    ("inspect", 2, "MODEL is required: veritope inspect MODEL"),
    ("inspect a.off b.off", 2, "the argument b.off is one too many: veritope inspect MODEL"),
    ("chain", 2, "MODEL is required: veritope chain MODEL"),
    ("render -o p.png", 2, "MODEL is required: veritope render MODEL"),
    ("project 0,0,0", 2, "SURFACE is required: veritope project POINT SURFACE"),
    ("explain M1 M2", 2, "the argument M2 is one too many: veritope explain [RULE]"),
    ("selftest all", 2, "the argument all is one too many: veritope selftest"),
    ("certify -", 2, "- is standard input and needs --format"),
    ("certify --format off - -", 2, "standard input can be read once only"),
    ("certify ''", 2, "a file name must not be empty"),
    ("convert a.off -", 2, "- is standard output and needs --to"),
]
OUTPUTS = [
    ("certify --json a.off a.off", 2, "the output a.off is the input a.off"),
    ("convert a.off a.off", 2, "the output a.off is the input a.off"),
    ("certify --json r --certificate r a.off", 2, "--json and --certificate would both write r"),
    ("certify --certificate b.off a.off models", 2, "--certificate b.off is a file; several inputs need a folder"),
    ("classify --certificate c a.off note.txt", 2, "--certificate needs -o with the name of a file, which the checker can read"),
    ("classify -o note.txt a.off note.txt", 2, "the output note.txt is the input note.txt"),
    ("chain a.off -o cells.stl", 2, "the name cells.stl does not end in .vtu"),
    ("chain a.off -o c.vtu --json c.vtu", 2, "would both write c.vtu"),
    ("inspect cube.itd --json cube.itd", 2, "the output cube.itd is the input cube.itd"),
    ("inspect cube.itd --json nowhere/r", 4, "nowhere/r: cannot be written"),
    ("chain a.off --json a.off", 2, "the output a.off is the input a.off"),
    ("build note.txt", 2, "-o OUT.vjson is required, the file of the volumes"),
    ("build note.txt -o b.itd", 2, "the name b.itd does not end in .vjson"),
    ("build note.txt -o b.vjson --json b.vjson", 2, "would both write b.vjson"),
    ("build note.txt -o nowhere/b.vjson", 4, "nowhere/b.vjson: cannot be written"),
    ("cage box --around a.off", 2, "-o C.vjson is required, the file of the cells"),
    ("cage box --around a.off -o c.off", 2, "the name c.off does not end in .vjson"),
    ("cage box --around a.off -o c.vjson --json c.vjson", 2, "would both write c.vjson"),
    ("cage box --around a.off -o nowhere/c.vjson", 4, "nowhere/c.vjson: cannot be written"),
    ("boolean A A=a.off", 2, "-o OUT.json is required, the file of the expression"),
    ("boolean A A=a.off -o e.json --json e.json", 2, "would both write e.json"),
    ("render a.off", 2, "-o F.png is required, the file of the picture"),
    ("render a.off -o p.png --json p.png", 2, "would both write p.png"),
    ("render a.off -o - --json -", 2, "the picture and --json would both write standard output"),
    ("render /dev/stdin -o p.png", 2, "MODEL is a file, not"),
    ("render a.off -o nowhere/p.png", 4, "nowhere/p.png: cannot be written"),
    ("certify --certificate - a.off", 2, "--certificate needs a file name, not -"),
    ("certify -q --json nowhere/r a.off", 4, "nowhere/r: cannot be written: No such file or directory"),
    ("certify -q --tsv empty a.off", 4, "empty: cannot be written: it is a directory"),
    ("convert --weld 1e-9 cube.itd o.vjson --json o.vjson", 2, "OUT and --json would both write o.vjson"),
    ("convert --weld 1e-9 cube.itd - --to vjson --json -", 2, "OUT and --json would both write standard output"),
    ("convert --weld 1e-9 cube.itd o.vjson --json cube.itd", 2, "the output cube.itd is the input cube.itd"),
    ("convert --weld 1e-9 cube.itd o.vjson --json nowhere/r", 4, "nowhere/r: cannot be written"),
    ("convert a.off empty", 2, "OUT names the new file, and empty is a folder"),
    ("cover cube.itd -o nowhere/o.vtu", 4, "nowhere/o.vtu: cannot be written"),
    ("certify -q --json /dev/full a.off", 4, "/dev/full: cannot be written: No space left on device"),
    ("certify -q --certificate /dev/full a.off", 4, "/dev/full: cannot be written: No space left on device"),
    ("convert --to stl a.off /dev/full", 4, "/dev/full: cannot be written: No space left on device"),
]
INPUTS = [
    ("certify nothing.off", 4, "nothing.off  cannot be read: No such file or directory"),
    ("certify *.nothing", 4, "(no file matches this pattern?)"),
    ("certify empty", 2, "no file in the folder empty has a known extension"),
    ("certify --glob *.zzz models", 2, "no file in the folder models has a name that matches *.zzz"),
    ("info models", 4, "it is a directory; certify takes folders, info files"),
    ("convert models o.stl", 4, "models: cannot be read: it is a directory"),
    ("predicate orient2d models", 4, "models: cannot be read: it is a directory"),
    ("explain-certificate a.off", 4, "a.off: not a certificate, as certify --certificate F writes it"),
    ("classify a.off models", 4, "models: cannot be read: it is a directory"),
    ("inspect none.itd", 4, "none.itd: cannot be read: No such file or directory"),
    ("chain none.off", 4, "none.off  cannot be read: No such file or directory"),
    ("boolean A A=none.off -o e.json", 4, "operand A: none.off: cannot be read: No such file or directory"),
    ("boolean A A=notes.txt -o e.json", 4, "operand A: notes.txt"),
    ("build none.json -o b.vjson", 4, "none.json: cannot be read: No such file or directory"),
    ("build note.txt -o b.vjson", 4, "note.txt: line 1: '{' expected"),
    ("build models -o b.vjson", 4, "models: cannot be read: it is a directory"),
    ("cage hull --around none.off -o c.vjson", 4, "none.off: cannot be read: No such file or directory"),
    ("cage split --of none.vjson --at u=1 -o c.vjson", 4, "none.vjson: cannot be read: No such file or directory"),
    ("cage split --of a.off --at u=1 -o c.vjson", 4, "this is a mesh (off); needed is a file of splines"),
    ("render none.off -o p.png", 4, "none.off: cannot be read: No such file or directory"),
    ("render none.off -o p.gltf --nets", 4, "none.off: cannot be read: No such file or directory"),
    ("render models -o p.png", 4, "models: cannot be read: it is a directory"),
    ("project 0,0,0 a.off", 4, "this is a mesh (off); needed is a file of splines"),
    ("certify part.step", 4, "this is a STEP file: not read yet"),
    ("certify note.txt", 4, "neither the ending of the name nor the content says"),
    ("certify junk.obj", 4, "it looks like binary data: byte 7 is 0"),
    ("info junk.itd", 4, "it looks like binary data: byte 7 is 0"),
    ("certify junk.stl", 4, "facets announced, but there is room for 1"),
    ("certify zero.stl", 4, "the header announces no facet"),
    ("certify comma.obj", 4, "'0,5' (a decimal comma?)"),
    ("certify count.off", 4, "'99999999999999999999' vertices and '4' faces announced"),
    ("certify void.stl", 4, "the file is empty"),
    ("certify --format itd a.off", 4, "it looks like off (--format off)"),
    ("certify /dev/zero", 4, "it is a character device (use - for standard input)"),
    ("predicate orient2d cases", 4, "cases:1: column 6: a number expected, but there is 'x'"),
]
JUNK = b"\x7fELF\x02\x01\x01\x00" + bytes((37 * i + 11) % 251 for i in range(160))


def split(line):
    """The words of a line; '' and quoted words as in a shell, but patterns stay as they are."""
    return [word.strip("'") for word in re.findall(r"'[^']*'|\S+", line)]


class WrongUsage(Folder):
    def setUp(self):
        super().setUp()
        for name in ("a.off", "b.off"):
            shutil.copy(VALID, self.folder / name)
        (self.folder / "models").mkdir()
        shutil.copy(VALID, self.folder / "models" / "m.off")
        (self.folder / "empty").mkdir()
        shutil.copy(MODELS / "patches" / "cube.itd", self.folder)
        for ending in ("obj", "itd", "stl"):
            (self.folder / f"junk.{ending}").write_bytes(JUNK)
        for name, text in [("cases", "0 0 1 0 0 x\n"), ("part.step", "ISO-10303-21;\nHEADER;\n"), ("note.txt", "hello\n"), ("void.stl", ""),
                           ("comma.obj", "v 0,5 1 2\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), ("count.off", "OFF\n99999999999999999999 4 0\n"),
                           ("zero.stl", "\0" * 1000)]:
            (self.folder / name).write_text(text)

    def contents(self):
        return {path: path.read_bytes() for path in self.folder.rglob("*") if path.is_file()}

    def assert_answered(self, line, status, words):
        before = self.listing(), self.contents()
        done = run(*split(line), cwd=self.folder, env=self.environment)
        self.assertEqual(done.returncode, status, done)
        self.assertEqual((self.listing(), self.contents()), before)
        answer = done.stderr if status == 2 else done.stdout + done.stderr
        if status == 2:
            self.assertEqual(done.stdout, "")
            self.assertTrue(done.stderr.startswith("veritope: "), done.stderr)
        if "/dev/full" in line:
            answer = done.stderr  # beside the verdict
        self.assertIn(len(answer.splitlines()), (1, 2), answer)
        self.assertIn(words, answer)
        said = answer.replace(line.split()[-1], "") if status == 4 else answer.splitlines()[0]
        for number in re.findall(r"\d{4,}", said):
            self.assertEqual(said.count(number), 1, answer)
        self.assertNotRegex(answer, r"terminate|what\(\)|At Most|Could not convert|not expected")

    def check(self, rows):
        for line, status, words in rows:
            with self.subTest(line):
                self.assert_answered(line, status, words)

    def test_misspelt_commands(self):
        self.check(COMMANDS)

    def test_options_that_are_unknown_or_contradict_one_another(self):
        self.check(OPTIONS)

    def test_values_that_an_option_or_an_argument_does_not_take(self):
        self.check(VALUES)

    def test_arguments_that_are_missing_or_too_many(self):
        self.check(COUNTS)

    def test_outputs_that_cannot_be_written(self):
        self.check(OUTPUTS)

    def test_files_that_are_not_what_they_should_be(self):
        self.check(INPUTS)

    def test_the_table_is_as_long_as_it_should_be_and_has_every_command(self):
        rows = COMMANDS + OPTIONS + VALUES + COUNTS + OUTPUTS + INPUTS
        self.assertGreaterEqual(len({line for line, _, _ in rows}), 60)
        listed = re.findall(r"(?m)^  ([a-z-]+) {2,}", run("--help").stdout.split("Subcommands:")[1])
        self.assertEqual(set(listed) - {split(line)[0] for line, _, _ in rows}, set())


if __name__ == "__main__":
    support.main()
