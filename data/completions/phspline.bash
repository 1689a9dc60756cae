# SPDX-License-Identifier: GPL-3.0-or-later
# Completions of phspline for bash; made by generate.sh.
_phspline() {
  local cur=${COMP_WORDS[COMP_CWORD]} option kind=words list=
  # --option=value is three words, --option value two
  if [[ $cur == = ]]; then
    cur= option=${COMP_WORDS[COMP_CWORD - 1]}=
  elif [[ ${COMP_WORDS[COMP_CWORD - 1]} == = ]]; then
    option=${COMP_WORDS[COMP_CWORD - 2]}=
  else
    option=${COMP_WORDS[COMP_CWORD - 1]}
  fi
  case $COMP_CWORD,${COMP_WORDS[1]} in
  1,*) list='planar spatial-hermite arclength sphere tc cone bubble verify help schema --help --version' ;;
  *,help | *,schema) list='planar spatial-hermite arclength sphere tc cone bubble verify' ;;
  *,planar)
    case $option in
    --points | --points=) kind=nothing ;;
    --closed=) list='true false' ;;
    --merge | --merge=) kind=nothing ;;
    --at | --at=) kind=nothing ;;
    --basis | --basis=) list='ph atph' ;;
    --knots | --knots=) list='chordal centripetal uniform' ;;
    --alpha | --alpha=) list='chordal' ;;
    --end_derivatives | --end_derivatives=) kind=nothing ;;
    --solutions | --solutions=) list='good all' ;;
    --minimize | --minimize=) list='E MV IES IMV' ;;
    --free | --free=) list='each scale' ;;
    -i | --input-format | --input-format=) list='auto json csv text geojson svg gpx obj' ;;
    --columns | --columns=) kind=nothing ;;
    --delimiter | --delimiter=) kind=nothing ;;
    --shard | --shard=) kind=nothing ;;
    --range | --range=) kind=nothing ;;
    -f | --format | --format=) list='json csv text npy svg-path svg geojson dxf obj stl opendrive gcode' ;;
    --feed | --feed=) kind=nothing ;;
    --unit | --unit=) list='mm cm m in' ;;
    --table | --table=) list='control-points lengths samples offsets' ;;
    --fields | --fields=) kind=nothing ;;
    -o | --output | --output=) kind=files ;;
    -s | --set | --set=) list='points= closed= merge= at= basis= knots= alpha= end_derivatives= solutions= minimize= free=' ;;
    --override | --override=) list='points= closed= merge= at= basis= knots= alpha= end_derivatives= solutions= minimize= free=' ;;
    -S | --sweep | --sweep=) list='points= closed= merge= at= basis= knots= alpha= end_derivatives= solutions= minimize= free=' ;;
    -d | --offset | --offset=) kind=nothing ;;
    --offset-mode | --offset-mode=) list='raw joined trimmed' ;;
    --offset-join | --offset-join=) kind=nothing ;;
    --offset-ends | --offset-ends=) list='none round' ;;
    --offset-sides | --offset-sides=) list='one both' ;;
    --offset-touching | --offset-touching=) list='split keep' ;;
    -n | --sample | --sample=) kind=nothing ;;
    --spacing | --spacing=) kind=nothing ;;
    --chord-error | --chord-error=) kind=nothing ;;
    --frame | --frame=) list='frenet erf rmf' ;;
    -p | --plot | --plot=) kind=files ;;
    --plot-size | --plot-size=) kind=nothing ;;
    --title | --title=) kind=nothing ;;
    --convert | --convert=) list='bezier' ;;
    --tolerance | --tolerance=) kind=nothing ;;
    -j | --jobs | --jobs=) kind=nothing ;;
    --max-samples | --max-samples=) kind=nothing ;;
    --max-memory | --max-memory=) kind=nothing ;;
    --max-record-bytes | --max-record-bytes=) kind=nothing ;;
    --time-limit | --time-limit=) kind=nothing ;;
    *)
      kind=files
      if [[ $cur == -* ]]; then
        kind=words list='--points= --closed --merge= --at= --basis= --knots= --alpha= --end_derivatives= --solutions= --minimize= --free= --input-format= --columns= --ignore-columns --delimiter= --shard= --range= --format= --feed= --unit= --table= --with-file --fields= --pretty --output= --if-changed --no-sync --set= --override= --sweep= --offset= --offset-mode= --offset-join= --offset-ends= --offset-sides= --offset-touching= --sample= --spacing= --chord-error= --frame= --plot= --plot-size= --title= --labels --convert= --offset-range --nurbs --tolerance= --jobs= --max-samples= --max-memory= --max-record-bytes= --time-limit= --strict --fail-fast --progress --quiet --verbose --help --version'
      fi
      ;;
    esac
    ;;
  *,spatial-hermite)
    case $option in
    --points | --points=) kind=nothing ;;
    --closed=) list='true false' ;;
    --merge | --merge=) kind=nothing ;;
    --at | --at=) kind=nothing ;;
    --tangents | --tangents=) kind=nothing ;;
    --derivatives | --derivatives=) kind=nothing ;;
    --basis | --basis=) list='ph atph' ;;
    --criterion | --criterion=) list='cc hc bv zero F1 F2 F3' ;;
    --angles | --angles=) kind=nothing ;;
    --axis | --axis=) list='chord x bisector' ;;
    --alpha | --alpha=) kind=nothing ;;
    --knots | --knots=) list='chordal' ;;
    --tension | --tension=) kind=nothing ;;
    --shape=) list='true false' ;;
    --planarity | --planarity=) kind=nothing ;;
    -i | --input-format | --input-format=) list='auto json csv text geojson svg gpx obj' ;;
    --columns | --columns=) kind=nothing ;;
    --delimiter | --delimiter=) kind=nothing ;;
    --shard | --shard=) kind=nothing ;;
    --range | --range=) kind=nothing ;;
    -f | --format | --format=) list='json csv text npy svg-path svg geojson dxf obj stl opendrive gcode' ;;
    --feed | --feed=) kind=nothing ;;
    --unit | --unit=) list='mm cm m in' ;;
    --table | --table=) list='control-points lengths samples offsets' ;;
    --fields | --fields=) kind=nothing ;;
    -o | --output | --output=) kind=files ;;
    -s | --set | --set=) list='points= closed= merge= at= tangents= derivatives= basis= criterion= angles= axis= alpha= knots= tension= shape= planarity=' ;;
    --override | --override=) list='points= closed= merge= at= tangents= derivatives= basis= criterion= angles= axis= alpha= knots= tension= shape= planarity=' ;;
    -S | --sweep | --sweep=) list='points= closed= merge= at= tangents= derivatives= basis= criterion= angles= axis= alpha= knots= tension= shape= planarity=' ;;
    -d | --offset | --offset=) kind=nothing ;;
    --offset-mode | --offset-mode=) list='raw joined trimmed' ;;
    --offset-join | --offset-join=) kind=nothing ;;
    --offset-ends | --offset-ends=) list='none round' ;;
    --offset-sides | --offset-sides=) list='one both' ;;
    --offset-touching | --offset-touching=) list='split keep' ;;
    -n | --sample | --sample=) kind=nothing ;;
    --spacing | --spacing=) kind=nothing ;;
    --chord-error | --chord-error=) kind=nothing ;;
    --frame | --frame=) list='frenet erf rmf' ;;
    -p | --plot | --plot=) kind=files ;;
    --plot-size | --plot-size=) kind=nothing ;;
    --title | --title=) kind=nothing ;;
    --convert | --convert=) list='bezier' ;;
    --tolerance | --tolerance=) kind=nothing ;;
    -j | --jobs | --jobs=) kind=nothing ;;
    --max-samples | --max-samples=) kind=nothing ;;
    --max-memory | --max-memory=) kind=nothing ;;
    --max-record-bytes | --max-record-bytes=) kind=nothing ;;
    --time-limit | --time-limit=) kind=nothing ;;
    *)
      kind=files
      if [[ $cur == -* ]]; then
        kind=words list='--points= --closed --merge= --at= --tangents= --derivatives= --basis= --criterion= --angles= --axis= --alpha= --knots= --tension= --shape --planarity= --input-format= --columns= --ignore-columns --delimiter= --shard= --range= --format= --feed= --unit= --table= --with-file --fields= --pretty --output= --if-changed --no-sync --set= --override= --sweep= --offset= --offset-mode= --offset-join= --offset-ends= --offset-sides= --offset-touching= --sample= --spacing= --chord-error= --frame= --plot= --plot-size= --title= --labels --convert= --offset-range --nurbs --tolerance= --jobs= --max-samples= --max-memory= --max-record-bytes= --time-limit= --strict --fail-fast --progress --quiet --verbose --help --version'
      fi
      ;;
    esac
    ;;
  *,arclength)
    case $option in
    --points | --points=) kind=nothing ;;
    --derivatives | --derivatives=) kind=nothing ;;
    --tangents | --tangents=) kind=nothing ;;
    --closed=) list='true false' ;;
    --merge | --merge=) kind=nothing ;;
    --at | --at=) kind=nothing ;;
    --lengths | --lengths=) kind=nothing ;;
    --length_sigma | --length_sigma=) kind=nothing ;;
    --tangent_sigma | --tangent_sigma=) kind=nothing ;;
    --knots | --knots=) list='lengths chordal uniform' ;;
    --refine | --refine=) list='auto' ;;
    --magnitudes | --magnitudes=) list='free mean' ;;
    --planar | --planar=) list='keep free' ;;
    --starts | --starts=) kind=nothing ;;
    --all_minima=) list='true false' ;;
    --start | --start=) kind=nothing ;;
    -i | --input-format | --input-format=) list='auto json csv text geojson svg gpx obj' ;;
    --columns | --columns=) kind=nothing ;;
    --delimiter | --delimiter=) kind=nothing ;;
    --shard | --shard=) kind=nothing ;;
    --range | --range=) kind=nothing ;;
    -f | --format | --format=) list='json csv text npy svg-path svg geojson dxf obj stl opendrive gcode' ;;
    --feed | --feed=) kind=nothing ;;
    --unit | --unit=) list='mm cm m in' ;;
    --table | --table=) list='control-points lengths samples offsets' ;;
    --fields | --fields=) kind=nothing ;;
    -o | --output | --output=) kind=files ;;
    -s | --set | --set=) list='points= derivatives= tangents= closed= merge= at= lengths= length_sigma= tangent_sigma= knots= refine= magnitudes= planar= starts= all_minima= start=' ;;
    --override | --override=) list='points= derivatives= tangents= closed= merge= at= lengths= length_sigma= tangent_sigma= knots= refine= magnitudes= planar= starts= all_minima= start=' ;;
    -S | --sweep | --sweep=) list='points= derivatives= tangents= closed= merge= at= lengths= length_sigma= tangent_sigma= knots= refine= magnitudes= planar= starts= all_minima= start=' ;;
    -d | --offset | --offset=) kind=nothing ;;
    --offset-mode | --offset-mode=) list='raw joined trimmed' ;;
    --offset-join | --offset-join=) kind=nothing ;;
    --offset-ends | --offset-ends=) list='none round' ;;
    --offset-sides | --offset-sides=) list='one both' ;;
    --offset-touching | --offset-touching=) list='split keep' ;;
    -n | --sample | --sample=) kind=nothing ;;
    --spacing | --spacing=) kind=nothing ;;
    --chord-error | --chord-error=) kind=nothing ;;
    --frame | --frame=) list='frenet erf rmf' ;;
    -p | --plot | --plot=) kind=files ;;
    --plot-size | --plot-size=) kind=nothing ;;
    --title | --title=) kind=nothing ;;
    --convert | --convert=) list='bezier' ;;
    --tolerance | --tolerance=) kind=nothing ;;
    -j | --jobs | --jobs=) kind=nothing ;;
    --max-samples | --max-samples=) kind=nothing ;;
    --max-memory | --max-memory=) kind=nothing ;;
    --max-record-bytes | --max-record-bytes=) kind=nothing ;;
    --time-limit | --time-limit=) kind=nothing ;;
    *)
      kind=files
      if [[ $cur == -* ]]; then
        kind=words list='--points= --derivatives= --tangents= --closed --merge= --at= --lengths= --length_sigma= --tangent_sigma= --knots= --refine= --magnitudes= --planar= --starts= --all_minima --start= --input-format= --columns= --ignore-columns --delimiter= --shard= --range= --format= --feed= --unit= --table= --with-file --fields= --pretty --output= --if-changed --no-sync --set= --override= --sweep= --offset= --offset-mode= --offset-join= --offset-ends= --offset-sides= --offset-touching= --sample= --spacing= --chord-error= --frame= --plot= --plot-size= --title= --labels --convert= --offset-range --nurbs --tolerance= --jobs= --max-samples= --max-memory= --max-record-bytes= --time-limit= --strict --fail-fast --progress --quiet --verbose --help --version'
      fi
      ;;
    esac
    ;;
  *,sphere)
    case $option in
    --points | --points=) kind=nothing ;;
    --lonlat | --lonlat=) kind=nothing ;;
    --closed=) list='true false' ;;
    --merge | --merge=) kind=nothing ;;
    --at | --at=) kind=nothing ;;
    --center | --center=) kind=nothing ;;
    --radius | --radius=) kind=nothing ;;
    --radius_tolerance | --radius_tolerance=) kind=nothing ;;
    --model | --model=) list='exact nielson' ;;
    --knots | --knots=) list='geodesic uniform' ;;
    --ends | --ends=) list='natural rest clamped' ;;
    --end_tangents | --end_tangents=) kind=nothing ;;
    --tension | --tension=) kind=nothing ;;
    --shape | --shape=) list='warn' ;;
    --increase | --increase=) list='minimal' ;;
    --criterion | --criterion=) list='geodesic legacy' ;;
    --epsilon | --epsilon=) kind=nothing ;;
    -i | --input-format | --input-format=) list='auto json csv text geojson svg gpx obj' ;;
    --columns | --columns=) kind=nothing ;;
    --delimiter | --delimiter=) kind=nothing ;;
    --shard | --shard=) kind=nothing ;;
    --range | --range=) kind=nothing ;;
    -f | --format | --format=) list='json csv text npy svg-path svg geojson dxf obj stl opendrive gcode' ;;
    --feed | --feed=) kind=nothing ;;
    --unit | --unit=) list='mm cm m in' ;;
    --table | --table=) list='control-points lengths samples offsets' ;;
    --fields | --fields=) kind=nothing ;;
    -o | --output | --output=) kind=files ;;
    -s | --set | --set=) list='points= lonlat= closed= merge= at= center= radius= radius_tolerance= model= knots= ends= end_tangents= tension= shape= increase= criterion= epsilon=' ;;
    --override | --override=) list='points= lonlat= closed= merge= at= center= radius= radius_tolerance= model= knots= ends= end_tangents= tension= shape= increase= criterion= epsilon=' ;;
    -S | --sweep | --sweep=) list='points= lonlat= closed= merge= at= center= radius= radius_tolerance= model= knots= ends= end_tangents= tension= shape= increase= criterion= epsilon=' ;;
    -d | --offset | --offset=) kind=nothing ;;
    --offset-mode | --offset-mode=) list='raw joined trimmed' ;;
    --offset-join | --offset-join=) kind=nothing ;;
    --offset-ends | --offset-ends=) list='none round' ;;
    --offset-sides | --offset-sides=) list='one both' ;;
    --offset-touching | --offset-touching=) list='split keep' ;;
    -n | --sample | --sample=) kind=nothing ;;
    --spacing | --spacing=) kind=nothing ;;
    --chord-error | --chord-error=) kind=nothing ;;
    --frame | --frame=) list='frenet erf rmf' ;;
    -p | --plot | --plot=) kind=files ;;
    --plot-size | --plot-size=) kind=nothing ;;
    --title | --title=) kind=nothing ;;
    --convert | --convert=) list='bezier' ;;
    --tolerance | --tolerance=) kind=nothing ;;
    -j | --jobs | --jobs=) kind=nothing ;;
    --max-samples | --max-samples=) kind=nothing ;;
    --max-memory | --max-memory=) kind=nothing ;;
    --max-record-bytes | --max-record-bytes=) kind=nothing ;;
    --time-limit | --time-limit=) kind=nothing ;;
    *)
      kind=files
      if [[ $cur == -* ]]; then
        kind=words list='--points= --lonlat= --closed --merge= --at= --center= --radius= --radius_tolerance= --model= --knots= --ends= --end_tangents= --tension= --shape= --increase= --criterion= --epsilon= --input-format= --columns= --ignore-columns --delimiter= --shard= --range= --format= --feed= --unit= --table= --with-file --fields= --pretty --output= --if-changed --no-sync --set= --override= --sweep= --offset= --offset-mode= --offset-join= --offset-ends= --offset-sides= --offset-touching= --sample= --spacing= --chord-error= --frame= --plot= --plot-size= --title= --labels --convert= --offset-range --nurbs --tolerance= --jobs= --max-samples= --max-memory= --max-record-bytes= --time-limit= --strict --fail-fast --progress --quiet --verbose --help --version'
      fi
      ;;
    esac
    ;;
  *,tc)
    case $option in
    --points | --points=) kind=nothing ;;
    --tangents | --tangents=) kind=nothing ;;
    --derivatives | --derivatives=) kind=nothing ;;
    --curve | --curve=) kind=nothing ;;
    --path | --path=) kind=nothing ;;
    --closed=) list='true false' ;;
    --merge | --merge=) kind=nothing ;;
    --at | --at=) kind=nothing ;;
    --mode | --mode=) list='g1 g1-pair g1-auto g1-fair c1 spline g2 approximate' ;;
    --lambda | --lambda=) kind=nothing ;;
    --ends | --ends=) list='chord circle smooth' ;;
    --end_tangents | --end_tangents=) kind=nothing ;;
    --end_derivatives | --end_derivatives=) kind=nothing ;;
    --auxiliary | --auxiliary=) list='auto never' ;;
    --joint | --joint=) list='free chord' ;;
    --joint_angle | --joint_angle=) kind=nothing ;;
    --joint_position | --joint_position=) kind=nothing ;;
    --solutions | --solutions=) list='best standard all' ;;
    --tolerance | --tolerance=) kind=nothing ;;
    --pieces | --pieces=) kind=nothing ;;
    --blaschke=) list='true false' ;;
    -i | --input-format | --input-format=) list='auto json csv text geojson svg gpx obj' ;;
    --columns | --columns=) kind=nothing ;;
    --delimiter | --delimiter=) kind=nothing ;;
    --shard | --shard=) kind=nothing ;;
    --range | --range=) kind=nothing ;;
    -f | --format | --format=) list='json csv text npy svg-path svg geojson dxf obj stl opendrive gcode' ;;
    --feed | --feed=) kind=nothing ;;
    --unit | --unit=) list='mm cm m in' ;;
    --table | --table=) list='control-points lengths samples offsets' ;;
    --fields | --fields=) kind=nothing ;;
    -o | --output | --output=) kind=files ;;
    -s | --set | --set=) list='points= tangents= derivatives= curve= path= closed= merge= at= mode= lambda= ends= end_tangents= end_derivatives= auxiliary= joint= joint_angle= joint_position= solutions= tolerance= pieces= blaschke=' ;;
    --override | --override=) list='points= tangents= derivatives= curve= path= closed= merge= at= mode= lambda= ends= end_tangents= end_derivatives= auxiliary= joint= joint_angle= joint_position= solutions= tolerance= pieces= blaschke=' ;;
    -S | --sweep | --sweep=) list='points= tangents= derivatives= curve= path= closed= merge= at= mode= lambda= ends= end_tangents= end_derivatives= auxiliary= joint= joint_angle= joint_position= solutions= tolerance= pieces= blaschke=' ;;
    -d | --offset | --offset=) kind=nothing ;;
    --offset-mode | --offset-mode=) list='raw joined trimmed' ;;
    --offset-join | --offset-join=) kind=nothing ;;
    --offset-ends | --offset-ends=) list='none round' ;;
    --offset-sides | --offset-sides=) list='one both' ;;
    --offset-touching | --offset-touching=) list='split keep' ;;
    -n | --sample | --sample=) kind=nothing ;;
    --spacing | --spacing=) kind=nothing ;;
    --chord-error | --chord-error=) kind=nothing ;;
    --frame | --frame=) list='frenet erf rmf' ;;
    -p | --plot | --plot=) kind=files ;;
    --plot-size | --plot-size=) kind=nothing ;;
    --title | --title=) kind=nothing ;;
    --convert | --convert=) list='bezier' ;;
    -j | --jobs | --jobs=) kind=nothing ;;
    --max-samples | --max-samples=) kind=nothing ;;
    --max-memory | --max-memory=) kind=nothing ;;
    --max-record-bytes | --max-record-bytes=) kind=nothing ;;
    --time-limit | --time-limit=) kind=nothing ;;
    *)
      kind=files
      if [[ $cur == -* ]]; then
        kind=words list='--points= --tangents= --derivatives= --curve= --path= --closed --merge= --at= --mode= --lambda= --ends= --end_tangents= --end_derivatives= --auxiliary= --joint= --joint_angle= --joint_position= --solutions= --tolerance= --pieces= --blaschke --input-format= --columns= --ignore-columns --delimiter= --shard= --range= --format= --feed= --unit= --table= --with-file --fields= --pretty --output= --if-changed --no-sync --set= --override= --sweep= --offset= --offset-mode= --offset-join= --offset-ends= --offset-sides= --offset-touching= --sample= --spacing= --chord-error= --frame= --plot= --plot-size= --title= --labels --convert= --offset-range --nurbs --jobs= --max-samples= --max-memory= --max-record-bytes= --time-limit= --strict --fail-fast --progress --quiet --verbose --help --version'
      fi
      ;;
    esac
    ;;
  *,cone)
    case $option in
    --points | --points=) kind=nothing ;;
    --rulings | --rulings=) kind=nothing ;;
    --tangents | --tangents=) kind=nothing ;;
    --normals | --normals=) kind=nothing ;;
    --closed=) list='true false' ;;
    --method | --method=) list='circular atph' ;;
    --lambda | --lambda=) list='equal' ;;
    --degenerate_tolerance | --degenerate_tolerance=) kind=nothing ;;
    --apexes | --apexes=) kind=nothing ;;
    --contact_point | --contact_point=) list='nearest midpoint' ;;
    --tangent_scale | --tangent_scale=) list='chord unit' ;;
    --criterion | --criterion=) list='F1 F2 F3' ;;
    --angles | --angles=) kind=nothing ;;
    --alpha | --alpha=) kind=nothing ;;
    --height | --height=) kind=nothing ;;
    --flat | --flat=) kind=nothing ;;
    --translate | --translate=) kind=nothing ;;
    --merge | --merge=) kind=nothing ;;
    -i | --input-format | --input-format=) list='auto json csv text geojson svg gpx obj' ;;
    --columns | --columns=) kind=nothing ;;
    --delimiter | --delimiter=) kind=nothing ;;
    --shard | --shard=) kind=nothing ;;
    --range | --range=) kind=nothing ;;
    -f | --format | --format=) list='json csv text npy svg-path svg geojson dxf obj stl opendrive gcode' ;;
    --unit | --unit=) list='mm cm m in' ;;
    --table | --table=) list='samples strips development located' ;;
    --fields | --fields=) kind=nothing ;;
    -o | --output | --output=) kind=files ;;
    -s | --set | --set=) list='points= rulings= tangents= normals= closed= method= lambda= degenerate_tolerance= apexes= contact_point= tangent_scale= criterion= angles= alpha= height= flat= translate= merge=' ;;
    --override | --override=) list='points= rulings= tangents= normals= closed= method= lambda= degenerate_tolerance= apexes= contact_point= tangent_scale= criterion= angles= alpha= height= flat= translate= merge=' ;;
    -S | --sweep | --sweep=) list='points= rulings= tangents= normals= closed= method= lambda= degenerate_tolerance= apexes= contact_point= tangent_scale= criterion= angles= alpha= height= flat= translate= merge=' ;;
    -d | --offset | --offset=) kind=nothing ;;
    -n | --sample | --sample=) kind=nothing ;;
    -p | --plot | --plot=) kind=files ;;
    --plot-size | --plot-size=) kind=nothing ;;
    --title | --title=) kind=nothing ;;
    --volume | --volume=) kind=nothing ;;
    --panorama | --panorama=) kind=files ;;
    --resolution | --resolution=) kind=nothing ;;
    --fill | --fill=) kind=nothing ;;
    --tolerance | --tolerance=) kind=nothing ;;
    -j | --jobs | --jobs=) kind=nothing ;;
    --max-samples | --max-samples=) kind=nothing ;;
    --max-memory | --max-memory=) kind=nothing ;;
    --max-record-bytes | --max-record-bytes=) kind=nothing ;;
    --time-limit | --time-limit=) kind=nothing ;;
    *)
      kind=files
      if [[ $cur == -* ]]; then
        kind=words list='--points= --rulings= --tangents= --normals= --closed --method= --lambda= --degenerate_tolerance= --apexes= --contact_point= --tangent_scale= --criterion= --angles= --alpha= --height= --flat= --translate= --merge= --input-format= --columns= --ignore-columns --delimiter= --shard= --range= --format= --unit= --table= --with-file --fields= --pretty --output= --if-changed --no-sync --set= --override= --sweep= --offset= --sample= --plot= --plot-size= --title= --labels --volume= --panorama= --resolution= --fill= --tolerance= --jobs= --max-samples= --max-memory= --max-record-bytes= --time-limit= --strict --fail-fast --progress --quiet --verbose --help --version'
      fi
      ;;
    esac
    ;;
  *,bubble)
    case $option in
    --points | --points=) kind=nothing ;;
    --faces | --faces=) kind=nothing ;;
    --normals | --normals=) kind=nothing ;;
    --continuity | --continuity=) kind=nothing ;;
    --degree | --degree=) list='auto exact' ;;
    --tolerance | --tolerance=) kind=nothing ;;
    --subdivide | --subdivide=) kind=nothing ;;
    --boundary | --boundary=) list='smooth fixed' ;;
    -i | --input-format | --input-format=) list='auto json csv text geojson svg gpx obj' ;;
    --columns | --columns=) kind=nothing ;;
    --delimiter | --delimiter=) kind=nothing ;;
    --shard | --shard=) kind=nothing ;;
    --range | --range=) kind=nothing ;;
    -f | --format | --format=) list='json csv text npy svg-path svg geojson dxf obj stl opendrive gcode' ;;
    --unit | --unit=) list='mm cm m in' ;;
    --table | --table=) list='samples patches edges' ;;
    --fields | --fields=) kind=nothing ;;
    -o | --output | --output=) kind=files ;;
    -s | --set | --set=) list='points= faces= normals= continuity= degree= tolerance= subdivide= boundary=' ;;
    --override | --override=) list='points= faces= normals= continuity= degree= tolerance= subdivide= boundary=' ;;
    -S | --sweep | --sweep=) list='points= faces= normals= continuity= degree= tolerance= subdivide= boundary=' ;;
    -d | --offset | --offset=) kind=nothing ;;
    -n | --sample | --sample=) kind=nothing ;;
    -p | --plot | --plot=) kind=files ;;
    --plot-size | --plot-size=) kind=nothing ;;
    --title | --title=) kind=nothing ;;
    -j | --jobs | --jobs=) kind=nothing ;;
    --max-samples | --max-samples=) kind=nothing ;;
    --max-memory | --max-memory=) kind=nothing ;;
    --max-record-bytes | --max-record-bytes=) kind=nothing ;;
    --time-limit | --time-limit=) kind=nothing ;;
    *)
      kind=files
      if [[ $cur == -* ]]; then
        kind=words list='--points= --faces= --normals= --continuity= --degree= --tolerance= --subdivide= --boundary= --input-format= --columns= --ignore-columns --delimiter= --shard= --range= --format= --unit= --table= --with-file --fields= --pretty --output= --if-changed --no-sync --set= --override= --sweep= --offset= --sample= --edges --plot= --plot-size= --title= --jobs= --max-samples= --max-memory= --max-record-bytes= --time-limit= --strict --fail-fast --progress --quiet --verbose --help --version'
      fi
      ;;
    esac
    ;;
  *,verify)
    case $option in
    --problems | --problems=) kind=files ;;
    -i | --input-format | --input-format=) list='auto json csv text geojson svg gpx obj' ;;
    --columns | --columns=) kind=nothing ;;
    --delimiter | --delimiter=) kind=nothing ;;
    --shard | --shard=) kind=nothing ;;
    --range | --range=) kind=nothing ;;
    -o | --output | --output=) kind=files ;;
    -s | --set | --set=) kind=nothing ;;
    --override | --override=) kind=nothing ;;
    --volume | --volume=) kind=nothing ;;
    --tolerance | --tolerance=) kind=nothing ;;
    -j | --jobs | --jobs=) kind=nothing ;;
    --max-memory | --max-memory=) kind=nothing ;;
    --max-record-bytes | --max-record-bytes=) kind=nothing ;;
    --time-limit | --time-limit=) kind=nothing ;;
    *)
      kind=files
      if [[ $cur == -* ]]; then
        kind=words list='--problems= --input-format= --columns= --ignore-columns --delimiter= --shard= --range= --pretty --output= --if-changed --no-sync --set= --override= --volume= --tolerance= --jobs= --max-memory= --max-record-bytes= --time-limit= --fail-fast --progress --quiet --verbose --help --version'
      fi
      ;;
    esac
    ;;
  esac
  COMPREPLY=()
  if [[ $kind == words ]]; then
    COMPREPLY=($(compgen -W "$list" -- "$cur"))
    [[ ${COMPREPLY[0]-} != *= ]] || compopt -o nospace 2>/dev/null
  elif [[ $kind == files ]]; then
    local IFS=$'\n'
    compopt -o filenames 2>/dev/null
    COMPREPLY=($(compgen -f -- "$cur"))
  fi
}
complete -F _phspline phspline
