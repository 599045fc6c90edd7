# The data that the guide's pictures show; read by tools/guide_pictures.sh, which sets $stemwise and $table.

# A table as people have them: no unit, one row that is none, codes for the status.
make_table() {
  { echo "nr;x;y;bhd;art;status"
    for i in $(seq 1 60); do
      echo "$i;$((i * 7 % 50)),$((i % 10));$((i * 13 % 40)),5;$((12 + i * 5 % 38));$([ $((i % 3)) = 0 ] && echo Fichte || echo Buche);$([ $((i % 9)) = 0 ] && echo T || echo L)"
    done
    echo "61;here;3,5;20;Buche;L"; } > "$table/plot_2021.csv"
}

# A table with much wrong in it, and one that is no table of stems.
make_broken_tables() {
  mkdir -p "$table/broken"
  { echo "tree,x_m,y_m,dbh_cm,species"
    for i in $(seq 1 40); do
      case $i in
        7) echo "7,12.4,,31.2,Picea abies" ;;
        13) echo "13,18.x,22.1,27.4,Picea abies" ;;
        19) echo "19,31.0,8.4,2740,Fagus sylvatica" ;;
        26) echo "13,31.5,18.2,33.1,Fagus sylvatica" ;;
        33) echo "33,40.1,12.7,-18.0,Abies alba" ;;
        *) echo "$i,$((i * 7 % 50)).$((i % 10)),$((i * 13 % 40)).5,$((12 + i * 5 % 38)).4,Picea abies" ;;
      esac
    done; } > "$table/broken/stand_2022.csv"
  printf 'station,rain_mm\nA,12\nB,7\n' > "$table/broken/weather.csv"
}

# Two surveys of a small stand, and a point cloud of the second one as a scanner might have seen it.
make_scan() {
  "$stemwise" simulate -o "$table/sim" --years 2018,2023 --stems 260 --area-ha 0.4 --seed 3 > /dev/null 2>&1
  awk -F, 'BEGIN { srand(1) }
    NR > 1 {
      d = ($5 > 0 ? $5 : 15) / 100; h = 1.3 + 30 * (1 - exp(-3.2 * d))
      for (i = 0; i < 420; i++) {
        a = 6.2832 * rand(); u = rand(); r = d / 2; z = h * 0.6 * rand()
        if (u < 0.35) { z = 0.05 * rand(); r = 3.5 * sqrt(rand()) }
        else if (u > 0.6) { t = rand(); z = h * (0.4 + 0.6 * t); r = (1 - t) * (1 + 5 * d) * sqrt(rand()) + 0.1 }
        low = u < 0.35 ? 0 : z
        printf "%.3f %.3f %.3f\n", $2 + $6 * low + r * cos(a), $3 + $7 * low + r * sin(a), $4 + z
      }
    }' "$table/sim/2023.csv" > "$table/points"
  { printf 'ply\nformat ascii 1.0\nelement vertex %d\nproperty float x\nproperty float y\nproperty float z\nend_header\n' "$(wc -l < "$table/points")"
    cat "$table/points"; } > "$table/sim/scan_2023.ply"
}

# Points around the demo's stand whose places agree to some centimetres; the last one was read wrongly.
make_control_points() {
  { echo "x_m,y_m,lat,lon,height_m"
    awk 'BEGIN { n = split("-245 -5 -145 0 -142 92 -240 88 -195 45 -175 20", p, " "); for (i = 1; i < n; i += 2) { e = (i * 7 % 5 - 2) * 0.03; x = p[i]; y = p[i + 1];
      printf "%.2f,%.2f,%.8f,%.8f,%.2f\n", x, y, 48.77214 + (y + e + (i > 10 ? 14 : 0)) / 111206.0, 9.16621 + (x - e) / 73465.0, 412 } }'; } > "$table/control.csv"
}

# Surveys as frame folders, and the track that a GNSS receiver wrote beside the first one.
make_frames_and_track() {
  "$stemwise" simulate -o "$table/frames" --frames --years 2019,2023 --stems 300 --area-ha 0.5 --seed 8 -q
  { echo "timestamp,lat,lon,height_m,sd_m"
    awk '!/^#/ && NF >= 4 { e = (NR * 7 % 5 - 2) * 0.2; printf "%s,%.8f,%.8f,%.2f,1.5\n", $1, 48.77214 + ($3 + e) / 111206.0, 9.16621 + ($2 - e) / 73465.0, 412 + $4 }' \
      "$table"/frames/2019*/trajectory.txt; } > "$table/track.csv"
}

# Surveys that share nothing; and five of one larger stand.
make_strangers() {
  "$stemwise" simulate -o "$table/a" --stems 400 --years 2015,2019 --seed 1 -q
  "$stemwise" simulate -o "$table/b" --stems 30 --years 2023,2027 --seed 2 -q
}
make_full() { "$stemwise" simulate -o "$table/full" --stems 2200 --years 2003,2008,2013,2018,2023 --seed 5 -q; }
