package lancer.correction.depot;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonDeserializer;
import com.google.gson.JsonPrimitive;
import com.google.gson.JsonSerializer;
import java.io.DataInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Base64;

/** Les messages des machines virtuelles qui lisent et compilent, et n'exécutent aucun rendu : des objets, par les noms de leurs champs. */
public final class Json {

    private static final Gson GSON = new GsonBuilder().disableHtmlEscaping()
            .registerTypeAdapter(byte[].class, (JsonSerializer<byte[]>) (octets, type, json) ->
                    new JsonPrimitive(Base64.getEncoder().encodeToString(octets)))
            .registerTypeAdapter(byte[].class, (JsonDeserializer<byte[]>) (texte, type, json) ->
                    Base64.getDecoder().decode(texte.getAsString())).create();

    private Json() {
    }

    public static byte[] ecrire(Object message) {
        return GSON.toJson(message).getBytes(StandardCharsets.UTF_8);
    }

    /** @throws RuntimeException si le message n'a pas cette forme */
    public static <T> T lire(Class<T> type, DataInputStream message) throws IOException {
        return GSON.fromJson(new String(message.readAllBytes(), StandardCharsets.UTF_8), type);
    }
}
