import java.io.BufferedReader;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.locationtech.jts.JTSVersion;
import org.locationtech.jts.algorithm.RobustLineIntersector;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.LineString;
import org.locationtech.jts.geom.Polygon;
import org.locationtech.jts.geom.PrecisionModel;
import org.locationtech.jts.noding.FastNodingValidator;
import org.locationtech.jts.noding.IntersectionAdder;
import org.locationtech.jts.noding.IteratedNoder;
import org.locationtech.jts.noding.MCIndexNoder;
import org.locationtech.jts.noding.NodedSegmentString;
import org.locationtech.jts.noding.Noder;
import org.locationtech.jts.noding.SegmentString;
import org.locationtech.jts.noding.snap.SnappingNoder;
import org.locationtech.jts.noding.snapround.SnapRoundingNoder;
import org.locationtech.jts.operation.overlayng.OverlayNGRobust;
import org.locationtech.jts.operation.polygonize.Polygonizer;

/** JTS's noders, one by one, each followed by its Polygonizer, by the protocol of ../README.md. */
public final class JtsAdapter {
  private static final double SNAP = 1e-10;
  private static final double GRID = 1e-9;
  private static final GeometryFactory FACTORY = new GeometryFactory();

  /** Noded lines of two points each, some of them repeated. */
  private interface Way {
    List<Coordinate[]> noded(double[] segments, double tolerance) throws Exception;
  }

  private record Configuration(
      String name, String title, String kind, double tolerance, String source, Way way,
      String wayTitle) {
    Configuration(String name, String title, String source, Way way) {
      this(name, title, "none", 0, source, way, "");
    }
  }

  /** A tolerance that an engine cannot have. */
  private static final class BadTolerance extends Exception {
    private static final long serialVersionUID = 1L;

    BadTolerance(String message) {
      super(message);
    }
  }

  private static final List<Configuration> CONFIGURATIONS =
      List.of(
          new Configuration("mcindex", "MCIndexNoder",
              "API: MCIndexNoder with an IntersectionAdder, one pass", by(t -> mcIndex())),
          new Configuration("mcindex-validated", "MCIndexNoder, FastNodingValidator",
              "API: FastNodingValidator checks that the result is fully noded",
              JtsAdapter::validated),
          new Configuration("iterated", "IteratedNoder",
              "API: IteratedNoder, 'repeated until no further intersections are detected'",
              by(t -> new IteratedNoder(new PrecisionModel()))),
          new Configuration("snapping-1e-10", "SnappingNoder 1e-10", "snap", SNAP,
              "API: SnappingNoder, 'a factor of about 10e-12 smaller than the magnitude'; "
                  + "here of 10",
              by(SnappingNoder::new), "SnappingNoder"),
          new Configuration("snap-rounding-1e-9", "SnapRoundingNoder 1e-9", "grid", GRID,
              "API: SnapRoundingNoder with a fixed PrecisionModel",
              by(t -> new SnapRoundingNoder(new PrecisionModel(scaleOf(t)))), "SnapRoundingNoder"),
          new Configuration("overlayng-robust", "OverlayNGRobust.union",
              "API: OverlayNGRobust, floating first, then snapping, then snap rounding",
              (segments, unused) -> piecesOf(OverlayNGRobust.union(lines(segments)))),
          new Configuration("union", "Geometry.union",
              "API: UnaryUnionOp, unions of lines are noded and dissolved; the old overlay, "
                  + "which is the default",
              (segments, unused) -> piecesOf(lines(segments).union())));

  private JtsAdapter() {}

  public static void main(String[] arguments) throws Exception {
    String wanted = arguments.length == 1 ? arguments[0] : "";
    if (wanted.equals("--list")) {
      System.out.println(listed());
      return;
    }
    Configuration chosen =
        CONFIGURATIONS.stream().filter(c -> c.name.equals(wanted)).findFirst().orElse(null);
    if (chosen == null) {
      System.err.println("usage: --list, or one of the configurations that it lists");
      System.exit(2);
    }
    // Standard output is for answers alone: what an engine prints goes to standard error.
    PrintStream answers =
        new PrintStream(new FileOutputStream(FileDescriptor.out), false, StandardCharsets.US_ASCII);
    System.setOut(System.err);
    BufferedReader cases = new BufferedReader(new InputStreamReader(System.in));
    for (String line = cases.readLine(); line != null; line = cases.readLine()) {
      answers.println(answer(chosen, line));
      answers.flush();
    }
  }

  private static String answer(Configuration configuration, String line) {
    String number = textOf("case", line);
    double[] segments = segmentsOf(line);
    long began = System.nanoTime();
    String said;
    double seconds;
    try {
      List<Coordinate[]> noded = once(configuration.way.noded(segments, toleranceOf(configuration, line)));
      Polygonizer polygonizer = new Polygonizer();
      for (Coordinate[] ends : noded) polygonizer.add(FACTORY.createLineString(ends));
      @SuppressWarnings("unchecked")
      Collection<Polygon> polygons = polygonizer.getPolygons();
      seconds = (System.nanoTime() - began) * 1e-9;
      said = isFinite(noded)
          ? "\"model\": " + new Model(noded, polygons)
          : failed("NotFinite", "coordinates of the result are not finite");
    } catch (Exception | AssertionError | StackOverflowError error) {
      seconds = (System.nanoTime() - began) * 1e-9;
      said = failed(error.getClass().getSimpleName(), error.getMessage());
    }
    return "{\"case\": " + number + ", \"seconds\": " + seconds + ", " + said + "}";
  }

  /** The word after a name; null where there is none. */
  private static String textOf(String name, String line) {
    Matcher found =
        Pattern.compile('"' + name + "\"\\s*:\\s*([-+.\\w]+|\"[^\"]*\")").matcher(line);
    return found.find() ? found.group(1) : null;
  }

  private static double toleranceOf(Configuration configuration, String line) throws BadTolerance {
    String wanted = textOf("tolerance", line);
    if (wanted == null) return configuration.tolerance;
    if (configuration.kind.equals("none")) {
      throw new BadTolerance("this configuration has no tolerance");
    }
    double tolerance;
    try {
      tolerance = Double.parseDouble(wanted);
    } catch (NumberFormatException error) {
      tolerance = Double.NaN;
    }
    if (!Double.isFinite(tolerance) || tolerance < 0) {
      throw new BadTolerance("a tolerance is a number, not below 0");
    }
    if (configuration.kind.equals("grid") && tolerance == 0) {
      throw new BadTolerance("a grid has a distance above 0");
    }
    return tolerance;
  }

  /** Of grids of powers of ten the integer; 1 / 1e-9 is another double. */
  private static double scaleOf(double grid) {
    double integer = Math.rint(1 / grid);
    return 1 / integer == grid ? integer : 1 / grid;
  }

  private static boolean isFinite(List<Coordinate[]> noded) {
    return noded.stream().allMatch(ends -> ends[0].isValid() && ends[1].isValid());
  }

  private static String failed(String kind, String message) {
    String said = message == null ? "" : message.substring(0, Math.min(message.length(), 500));
    return "\"error\": {\"class\": " + quoted(kind) + ", \"message\": " + quoted(said) + "}";
  }

  /** The numbers of a case, four for each segment, without segments of length 0. */
  private static double[] segmentsOf(String line) {
    String inner = line.substring(line.indexOf('[', line.indexOf("\"segments\"")));
    inner = inner.substring(0, inner.lastIndexOf(']'));
    String[] texts = inner.replaceAll("[\\[\\],]", " ").trim().split("\\s+");
    if (texts.length < 4) return new double[0];
    double[] numbers = new double[texts.length];
    int kept = 0;
    for (int i = 0; i + 3 < texts.length; i += 4) {
      for (int k = 0; k < 4; ++k) {
        numbers[kept + k] = Double.parseDouble(texts[i + k]) + 0.0; // no -0.0
      }
      boolean isPoint =
          numbers[kept] == numbers[kept + 2] && numbers[kept + 1] == numbers[kept + 3];
      if (!isPoint) kept += 4;
    }
    return java.util.Arrays.copyOf(numbers, kept);
  }

  private interface MakesNoder {
    Noder make(double tolerance);
  }

  private static Way by(MakesNoder noder) {
    return (segments, tolerance) -> nodedBy(noder.make(tolerance), segments);
  }

  private static Noder mcIndex() {
    return new MCIndexNoder(new IntersectionAdder(new RobustLineIntersector()));
  }

  private static List<Coordinate[]> validated(double[] segments, double unused) {
    Noder noder = mcIndex();
    List<SegmentString> strings = strings(segments);
    noder.computeNodes(strings);
    new FastNodingValidator(noder.getNodedSubstrings()).checkValid();
    return pieces(noder.getNodedSubstrings());
  }

  private static List<Coordinate[]> nodedBy(Noder noder, double[] segments) {
    noder.computeNodes(strings(segments));
    return pieces(noder.getNodedSubstrings());
  }

  private static List<SegmentString> strings(double[] segments) {
    List<SegmentString> strings = new ArrayList<>();
    for (int i = 0; i < segments.length; i += 4) {
      strings.add(new NodedSegmentString(ends(segments, i), null));
    }
    return strings;
  }

  private static Coordinate[] ends(double[] segments, int i) {
    return new Coordinate[] {
      new Coordinate(segments[i], segments[i + 1]), new Coordinate(segments[i + 2], segments[i + 3])
    };
  }

  private static List<Coordinate[]> pieces(Collection<?> strings) {
    List<Coordinate[]> pieces = new ArrayList<>();
    for (Object string : strings) addPieces(((SegmentString) string).getCoordinates(), pieces);
    return pieces;
  }

  private static void addPieces(Coordinate[] line, List<Coordinate[]> pieces) {
    for (int k = 1; k < line.length; ++k) pieces.add(new Coordinate[] {line[k - 1], line[k]});
  }

  private static Geometry lines(double[] segments) {
    LineString[] lines = new LineString[segments.length / 4];
    for (int i = 0; i < lines.length; ++i) {
      lines[i] = FACTORY.createLineString(ends(segments, 4 * i));
    }
    return FACTORY.createMultiLineString(lines);
  }

  private static List<Coordinate[]> piecesOf(Geometry union) {
    List<Coordinate[]> pieces = new ArrayList<>();
    for (int i = 0; i < union.getNumGeometries(); ++i) {
      addPieces(union.getGeometryN(i).getCoordinates(), pieces);
    }
    return pieces;
  }

  /** Each piece once, in either direction, without those of no length. */
  private static List<Coordinate[]> once(List<Coordinate[]> pieces) {
    TreeSet<Coordinate[]> seen =
        new TreeSet<>(
            (a, b) -> a[0].equals2D(b[0]) ? a[1].compareTo(b[1]) : a[0].compareTo(b[0]));
    for (Coordinate[] piece : pieces) {
      int order = piece[0].compareTo(piece[1]);
      if (order < 0) seen.add(piece);
      if (order > 0) seen.add(new Coordinate[] {piece[1], piece[0]});
    }
    return new ArrayList<>(seen);
  }

  /** Noded pieces and polygons as JSON, with vertices numbered in the order in which they come. */
  private static final class Model {
    private final Map<Coordinate, Integer> number = new HashMap<>();
    private final List<String> vertices = new ArrayList<>();
    private final String edges;
    private final String polygons;

    Model(List<Coordinate[]> noded, Collection<Polygon> faces) {
      List<String> pairs = new ArrayList<>();
      for (Coordinate[] ends : noded) {
        pairs.add("[" + numbered(ends[0]) + ", " + numbered(ends[1]) + "]");
      }
      edges = "[" + String.join(", ", pairs) + "]";
      List<String> all = new ArrayList<>();
      for (Polygon face : faces) all.add(rings(face));
      polygons = "[" + String.join(", ", all) + "]";
    }

    private int numbered(Coordinate point) {
      Coordinate at = new Coordinate(point.x + 0.0, point.y + 0.0); // -0.0 is 0.0
      return number.computeIfAbsent(
          at,
          p -> {
            vertices.add("[" + p.x + ", " + p.y + "]");
            return vertices.size() - 1;
          });
    }

    private String rings(Polygon face) {
      List<String> rings = new ArrayList<>();
      rings.add(ring(face.getExteriorRing()));
      for (int i = 0; i < face.getNumInteriorRing(); ++i) rings.add(ring(face.getInteriorRingN(i)));
      return "[" + String.join(", ", rings) + "]";
    }

    private String ring(LineString ring) {
      Coordinate[] points = ring.getCoordinates();
      List<String> numbers = new ArrayList<>();
      for (int i = 0; i + 1 < points.length; ++i) numbers.add(String.valueOf(numbered(points[i])));
      return "[" + String.join(", ", numbers) + "]";
    }

    @Override
    public String toString() {
      return "{\"V\": [" + String.join(", ", vertices) + "], \"EV\": " + edges + ", \"polygons\": "
          + polygons + "}";
    }
  }

  private static String listed() {
    List<String> configurations = new ArrayList<>();
    for (Configuration c : CONFIGURATIONS) {
      configurations.add(
          "{\"name\": " + quoted(c.name) + ", \"title\": " + quoted(c.title)
              + ", \"tolerance\": {\"kind\": " + quoted(c.kind) + ", \"value\": " + c.tolerance
              + ", \"way\": " + quoted(c.wayTitle) + "}, \"source\": " + quoted(c.source) + "}");
    }
    String version = JTSVersion.CURRENT_VERSION.toString();
    return "{\"engine\": " + quoted(System.getProperty("engine", "jts"))
        + ", \"title\": \"JTS\", \"version\": " + quoted(version)
        + ", \"algorithm\": " + quoted("JTS " + version) + ", \"licence\": "
        + "\"EPL-2.0 or EDL-1.0\", \"configurations\": ["
        + String.join(", ", configurations) + "]}";
  }

  private static String quoted(String text) {
    StringBuilder out = new StringBuilder("\"");
    for (char c : text.toCharArray()) {
      if (c == '"' || c == '\\') out.append('\\');
      out.append(c < ' ' || c > '~' ? ' ' : c);
    }
    return out.append('"').toString();
  }
}
