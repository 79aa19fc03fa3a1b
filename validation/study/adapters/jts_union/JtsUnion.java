import java.io.BufferedReader;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import org.locationtech.jts.JTSVersion;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.LinearRing;
import org.locationtech.jts.geom.Polygon;
import org.locationtech.jts.operation.overlayng.OverlayNG;
import org.locationtech.jts.operation.overlayng.OverlayNGRobust;

/** JTS's union and symmetric difference of polygons, by the protocol of ../README.md. */
public final class JtsUnion {
  private static final String NAME = "overlayng-robust";
  private static final GeometryFactory FACTORY = new GeometryFactory();

  private JtsUnion() {}

  public static void main(String[] arguments) throws Exception {
    String wanted = arguments.length == 1 ? arguments[0] : "";
    if (wanted.equals("--list")) {
      System.out.println(listed());
      return;
    }
    if (!wanted.equals(NAME)) {
      System.err.println("usage: --list, or " + NAME);
      System.exit(2);
    }
    // Standard output is for answers alone: what an engine prints goes to standard error.
    PrintStream answers =
        new PrintStream(new FileOutputStream(FileDescriptor.out), false, StandardCharsets.US_ASCII);
    System.setOut(System.err);
    BufferedReader cases = new BufferedReader(new InputStreamReader(System.in));
    for (String line = cases.readLine(); line != null; line = cases.readLine()) {
      answers.println(answer(line));
      answers.flush();
    }
  }

  private static String answer(String line) {
    String number = line.replaceFirst(".*\"case\"\\s*:\\s*(-?[0-9]+).*", "$1");
    boolean isEvenOdd = line.matches(".*\"rule\"\\s*:\\s*\"evenodd\".*");
    List<Geometry> polygons = polygonsOf(line);
    long began = System.nanoTime();
    String said;
    double seconds;
    try {
      Geometry region = isEvenOdd ? parity(polygons) : union(polygons);
      seconds = (System.nanoTime() - began) * 1e-9;
      said = "\"model\": " + new Model(region);
    } catch (Exception | AssertionError | StackOverflowError error) {
      seconds = (System.nanoTime() - began) * 1e-9;
      String message = error.getMessage() == null ? "" : error.getMessage();
      said = "\"error\": {\"class\": " + quoted(error.getClass().getSimpleName())
          + ", \"message\": " + quoted(message.substring(0, Math.min(500, message.length()))) + "}";
    }
    return "{\"case\": " + number + ", \"seconds\": " + seconds + ", " + said + "}";
  }

  private static Geometry union(List<Geometry> polygons) {
    return polygons.isEmpty()
        ? FACTORY.createPolygon()
        : OverlayNGRobust.union(polygons, FACTORY);
  }

  private static Geometry parity(List<Geometry> polygons) {
    Geometry region = FACTORY.createPolygon();
    for (Geometry polygon : polygons) {
      region = OverlayNGRobust.overlay(region, polygon, OverlayNG.SYMDIFFERENCE);
    }
    return region;
  }

  /** The rings of a case as polygons. */
  private static List<Geometry> polygonsOf(String line) {
    String rest = line.substring(line.indexOf('[', line.indexOf("\"rings\"")));
    List<Geometry> polygons = new ArrayList<>();
    List<Coordinate> ring = new ArrayList<>();
    StringBuilder text = new StringBuilder();
    int depth = 0;
    for (int i = 0; i < rest.length(); ++i) {
      char c = rest.charAt(i);
      if (c == '[') ++depth;
      else if (c == ']' && depth-- == 3) {
        String[] xy = text.toString().split(",");
        ring.add(new Coordinate(Double.parseDouble(xy[0]) + 0.0, Double.parseDouble(xy[1]) + 0.0));
        text.setLength(0);
      } else if (c == ']' && depth == 1) {
        addPolygon(ring, polygons);
        ring.clear();
      } else if (depth == 3) text.append(c);
      if (depth == 0) break;
    }
    return polygons;
  }

  private static void addPolygon(List<Coordinate> ring, List<Geometry> polygons) {
    if (ring.size() < 3) return;
    ring.add(ring.get(0));
    polygons.add(FACTORY.createPolygon(ring.toArray(new Coordinate[0])));
  }

  /** A region as JSON, with vertices numbered in the order in which they come. */
  private static final class Model {
    private final Map<Coordinate, Integer> number = new LinkedHashMap<>();
    private final TreeSet<String> sides = new TreeSet<>();
    private final List<String> polygons = new ArrayList<>();

    Model(Geometry region) {
      for (int i = 0; i < region.getNumGeometries(); ++i) {
        if (region.getGeometryN(i) instanceof Polygon polygon && !polygon.isEmpty()) {
          List<String> rings = new ArrayList<>();
          rings.add(ring(polygon.getExteriorRing()));
          for (int k = 0; k < polygon.getNumInteriorRing(); ++k) {
            rings.add(ring(polygon.getInteriorRingN(k)));
          }
          polygons.add("[" + String.join(", ", rings) + "]");
        }
      }
    }

    private String ring(LinearRing ring) {
      List<String> numbers = new ArrayList<>();
      int before = -1;
      for (Coordinate point : ring.getCoordinates()) {
        Coordinate at = new Coordinate(point.x + 0.0, point.y + 0.0); // -0.0 is 0.0
        int here = number.computeIfAbsent(at, p -> number.size());
        if (before >= 0) {
          numbers.add(String.valueOf(before));
          sides.add("[" + Math.min(before, here) + ", " + Math.max(before, here) + "]");
        }
        before = here;
      }
      return "[" + String.join(", ", numbers) + "]";
    }

    @Override
    public String toString() {
      List<String> vertices = new ArrayList<>();
      for (Coordinate p : number.keySet()) vertices.add("[" + p.x + ", " + p.y + "]");
      return "{\"V\": [" + String.join(", ", vertices) + "], \"EV\": [" + String.join(", ", sides)
          + "], \"polygons\": [" + String.join(", ", polygons) + "]}";
    }
  }

  private static String listed() {
    String version = JTSVersion.CURRENT_VERSION.toString();
    return "{\"engine\": \"jts_union\", \"input\": \"rings\", \"takes\": [\"simple evenodd\", "
        + "\"simple nonzero\"], \"title\": \"JTS\", \"version\": " + quoted(version)
        + ", \"algorithm\": " + quoted("JTS " + version) + ", \"licence\": "
        + "\"EPL-2.0 or EDL-1.0\", \"configurations\": [{\"name\": " + quoted(NAME)
        + ", \"title\": \"OverlayNGRobust\", \"tolerance\": {\"kind\": \"none\", \"value\": 0}, "
        + "\"source\": \"API: OverlayNGRobust.union of a collection; overlay, SYMDIFFERENCE\"}]}";
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
