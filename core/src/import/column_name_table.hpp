#pragma once

#include <array>
#include <string_view>

#include "column_names.hpp"

/// Names of columns in several habits and languages. Small letters, ä as ae, å as aa, ø as o, é as e, no accents and
/// punctuation; the order of the words and words such as "actual" or "sensor" do not matter.
namespace swayaw::inline core::detail {

struct NameRow {
  Quantity quantity;
  std::string_view habit;
  std::string_view names;  ///< separated by bars
};

inline constexpr std::array name_table{
    NameRow{
        Quantity::time, "English",
        "time|t|times|time stamp|timestamp|utc|gmt|utc time|time utc|gmt time|local time|time of day|elapsed|elapsed "
        "time|date time|datetime|date and time|date time utc|clock|seconds|sec|unix time|unixtime|epoch|time local"},
    NameRow{Quantity::time, "German", "zeit|uhrzeit|zeitstempel|datum uhrzeit|datum zeit|messzeit|laufzeit|zeitpunkt"},
    NameRow{Quantity::time, "Norwegian, Danish", "tid|klokkeslett|klokkeslaet|tidspunkt|tidsstempel|dato tid"},
    NameRow{Quantity::time, "Dutch", "tijd|tijdstip|tijdstempel|datum tijd"},
    NameRow{Quantity::time, "Spanish", "tiempo|hora|fecha hora|marca tiempo"},
    NameRow{Quantity::time, "Japanese", "jikan|jikoku|nichiji"},
    NameRow{Quantity::date, "all", "date|datum|dato|fecha|hizuke|nengappi|utc date|date utc|day"},

    NameRow{Quantity::heading, "English",
            "heading|hdg|hdt|head|true heading|true hdg|heading t|hdg t|gyro|gyro heading|gyro hdg|gyro compass|"
            "gyrocompass|compass|compass heading|compass hdg|yaw|yaw angle|psi|heading angle|bow heading|yaw attitude"},
    NameRow{Quantity::heading, "German",
            "kurs|steuerkurs|kreisel|kreiselkurs|kreiselkompass|kompasskurs|kurs kreisel|rwk|rechtweisender kurs|"
            "kurs rechtweisend|kurswinkel|gierwinkel|schiffskurs|vorausrichtung|richtung voraus"},
    NameRow{
        Quantity::heading, "Norwegian, Danish",
        "stevnretning|styrt kurs|styrekurs|gyrokurs|gyro kurs|retvisende kurs|rettvisende kurs|kompaskurs|baugretning"},
    NameRow{Quantity::heading, "Dutch", "koers|voorligging|stuurkoers|gyrokoers|ware koers|kompaskoers|gierhoek"},
    NameRow{Quantity::heading, "Spanish",
            "rumbo|rumbo verdadero|rumbo giroscopico|proa|angulo guinada|guinada|rumbo giro compas"},
    NameRow{Quantity::heading, "Japanese",
            "hoi|houi|senshu hoi|senshu houi|senshuhoi|sensyu hoi|kaito kaku|kaitou kaku"},
    NameRow{Quantity::magnetic_heading, "all",
            "hdm|magnetic heading|heading magnetic|heading m|hdg m|mag heading|mag hdg|magnetkurs|magnetkompass|"
            "missweisender kurs|magnetic compass|magnetisk kurs|magnetische koers|rumbo magnetico|jiki hoi"},

    NameRow{Quantity::course, "English",
            "cog|course over ground|course ground|ground course|course made good|cmg|track made good|track angle|"
            "true track|gps course|gps cog|cog true|course over ground true|cog t|drift course"},
    NameRow{Quantity::course, "German",
            "kurs ue grund|kurs ueber grund|kurs ue g|kueg|kug|grundkurs|gps kurs|kurs grund|kurs gps|kursueg"},
    NameRow{Quantity::course, "Norwegian, Danish", "kurs over grunn|kurs over grund|beholden kurs|beholdt kurs"},
    NameRow{Quantity::course, "Dutch", "koers over grond|grondkoers|koers grond|kog"},
    NameRow{Quantity::course, "Spanish", "rumbo sobre fondo|rumbo fondo|rumbo efectivo|derrota|rsf"},
    NameRow{Quantity::course, "Japanese", "taichi shinro|taichi harikoro|taichi hoi"},
    NameRow{Quantity::course_unsaid, "all", "course|track|crs|course true|true course|curso|shinro|harikoro"},

    NameRow{Quantity::yaw_rate, "English",
            "rot|yaw|gyro|rate of turn|rate turn|turn rate|turning rate|yaw rate|yawrate|r|yaw velocity|yaw speed|psi "
            "dot|psidot|"
            "gyro rate|heading rate|rate gyro|yaw angular velocity|angular velocity yaw|yaw rate r|r yaw rate|dpsi dt"},
    NameRow{Quantity::yaw_rate, "German",
            "wendegeschwindigkeit|drehgeschwindigkeit|drehrate|gierrate|giergeschwindigkeit|wendezeiger|wenderate|"
            "kursaenderungsgeschwindigkeit"},
    NameRow{Quantity::yaw_rate, "Norwegian, Danish",
            "svinghastighet|svinghastighed|dreiehastighet|drejehastighed|girrate|girhastighet|girhastighed|svingrate"},
    NameRow{Quantity::yaw_rate, "Dutch", "bochtaanwijzer|draaisnelheid|giersnelheid|bochtsnelheid"},
    NameRow{Quantity::yaw_rate, "Spanish",
            "velocidad giro|velocidad guinada|razon giro|razon guinada|regimen giro|tasa giro|velocidad angular"},
    NameRow{Quantity::yaw_rate, "Japanese",
            "kaito kakusokudo|kaitou kakusokudo|senkai kakusokudo|kaito ritsu|kaitouritsu|kakusokudo|kaito sokudo"},

    NameRow{Quantity::rudder, "English",
            "rudder|rudder angle|rudder position|rudder pos|rsa|rudder deflection|rudder indicator|rai|rud|rudder ang|"
            "rud ang|rud angle|delta|rudder sensor angle|rudder angle indicator|rudder angle delta|delta rudder"},
    NameRow{Quantity::rudder, "German",
            "ruder|ruderlage|ruderwinkel|ruderausschlag|ruderlagenanzeige|ruderlageanzeige|ruderstellung|rudlage"},
    NameRow{Quantity::rudder, "Norwegian, Danish",
            "ror|rorvinkel|rorutslag|rorudslag|rorstilling|ror vinkel|ror posisjon"},
    NameRow{Quantity::rudder, "Dutch", "roer|roerhoek|roerstand|roeruitslag"},
    NameRow{Quantity::rudder, "Spanish", "timon|angulo timon|pala|angulo pala|posicion timon"},
    NameRow{Quantity::rudder, "Japanese", "dakaku|jitsu dakaku|jissai dakaku|kaji|kaji kaku|kajikaku|da kaku"},

    NameRow{Quantity::rudder_order, "English",
            "rudder order|ordered rudder|rudder command|commanded rudder|rudder cmd|rudder demand|rudder set|"
            "rudder setpoint|rudder set point|rudder order angle|rudder angle order|rudder angle cmd|rudder angle "
            "command|ordered rudder angle|commanded rudder angle|rudder angle demand|rudder angle setpoint|delta order|"
            "delta cmd|delta command|delta c|deltac|delta ordered|rudder request|rudder reference|rudder ref|delta ref|"
            "rud cmd|rud order|helm order|rudder desired|desired rudder|rudder angle ordered"},
    NameRow{Quantity::rudder_order, "German",
            "ruder soll|ruderlage soll|ruderwinkel soll|ruder sollwert|sollruder|ruderkommando|ruder kommando|"
            "rudersollwert|ruderbefehl|ruderlage sollwert|ruderwinkel sollwert|sollruderlage|sollruderwinkel"},
    NameRow{Quantity::rudder_order, "Norwegian, Danish",
            "rorordre|ror ordre|rorkommando|ror kommando|beordret rorvinkel|beordret ror|ror settpunkt|ror setpunkt"},
    NameRow{Quantity::rudder_order, "Dutch", "roercommando|roer commando|gewenste roerhoek|roerorder|roer order"},
    NameRow{Quantity::rudder_order, "Spanish",
            "orden timon|timon orden|angulo timon orden|timon ordenado|angulo timon ordenado"},
    NameRow{Quantity::rudder_order, "Japanese", "shirei dakaku|meirei dakaku|dakaku shirei|dakaku meirei|so dakaku"},

    NameRow{Quantity::log_speed, "English",
            "stw|speed through water|speed water|water speed|log|log speed|speed log|ship log|ship speed log|"
            "doppler log|em log|vlw|speed through water stw|longitudinal water speed"},
    NameRow{Quantity::log_speed, "German",
            "fahrt|fahrt durchs wasser|fahrt durch wasser|fdw|fahrt d wasser|geschwindigkeit durchs wasser|"
            "geschwindigkeit durch wasser|logge|fahrt logge|logfahrt|loggefahrt"},
    NameRow{
        Quantity::log_speed, "Norwegian, Danish",
        "fart gjennom vann|fart gjennom vannet|fart gennem vand|fart gennem vandet|logg|loggfart|logfart|fart logg"},
    NameRow{Quantity::log_speed, "Dutch", "snelheid door water|vaart door water|log snelheid|logsnelheid"},
    NameRow{Quantity::log_speed, "Spanish", "velocidad agua|velocidad en agua|corredera|velocidad corredera"},
    NameRow{Quantity::log_speed, "Japanese", "taisui sokuryoku|taisui sokudo|taisui senzoku"},

    NameRow{Quantity::ground_speed, "English",
            "sog|speed over ground|speed ground|ground speed|gps speed|gps sog|speed gps|speed made good|smg|vog|"
            "speed over ground sog"},
    NameRow{Quantity::ground_speed, "German",
            "fahrt ue grund|fahrt ueber grund|fahrt ue g|fueg|fug|geschwindigkeit ueber grund|gps fahrt|fahrt gps|"
            "gps geschwindigkeit|fahrt grund|geschwindigkeit ue grund"},
    NameRow{Quantity::ground_speed, "Norwegian, Danish",
            "fart over grunn|fart over grunnen|fart over grund|gps fart|fart over grunden"},
    NameRow{Quantity::ground_speed, "Dutch", "snelheid over grond|vaart over grond|grondsnelheid|gps snelheid|vog"},
    NameRow{Quantity::ground_speed, "Spanish",
            "velocidad sobre fondo|velocidad fondo|velocidad gps|vsf|velocidad efectiva"},
    NameRow{Quantity::ground_speed, "Japanese", "taichi sokuryoku|taichi sokudo|taichi senzoku"},
    NameRow{Quantity::speed_unsaid, "all",
            "speed|ship speed|velocity|spd|vs|geschwindigkeit|schiffsgeschwindigkeit|fart|snelheid|vaart|velocidad|"
            "senzoku|sokuryoku|sokudo|hastighet|hastighed|total speed|speed total|resultant speed"},

    NameRow{Quantity::latitude, "all",
            "lat|latitude|gps lat|gps latitude|breite|breitengrad|geographische breite|gps breite|breddegrad|bredde|"
            "breedtegraad|breedte|latitud|ido|lat dd|position lat|pos lat|position latitude|lat wgs 84|lat gps"},
    NameRow{Quantity::longitude, "all",
            "lon|long|lng|longitude|gps lon|gps long|gps longitude|laenge|laengengrad|geographische laenge|gps laenge|"
            "lengdegrad|lengde|laengdegrad|laengde|lengtegraad|lengte|longitud|keido|lon dd|position lon|pos lon|"
            "pos long|position longitude|lon wgs 84|lon gps"},
    NameRow{Quantity::shaft_speed, "symbol", "n"},
    NameRow{
        Quantity::north, "all",
        "north|northing|n|x|x north|north x|pos x|position x|x pos|x position|pos n|pos north|position north|x earth|"
        "x 0|nord|hochwert|noord|norte|kita|north position|utm northing|utm north|utm n"},
    NameRow{Quantity::east, "all",
            "east|easting|e|y|y east|east y|pos y|position y|y pos|y position|pos e|pos east|position east|y earth|y 0|"
            "ost|oest|rechtswert|oost|este|higashi|east position|utm easting|utm east|utm e"},
    NameRow{Quantity::surge, "all",
            "u|surge|surge velocity|surge speed|u surge|surge u|forward speed|longitudinal speed|laengsgeschwindigkeit|"
            "forward velocity|longitudinal velocity"},
    NameRow{Quantity::sway, "all",
            "v|sway|sway velocity|sway speed|v sway|sway v|transverse speed|lateral speed|quergeschwindigkeit|"
            "querfahrt|lateral velocity|transverse velocity"},
    NameRow{Quantity::ground_surge, "all",
            "ug|u ground|surge over ground|longitudinal ground speed|u over ground|longitudinal speed over ground|"
            "laengsgeschwindigkeit ueber grund"},
    NameRow{Quantity::ground_sway, "all",
            "vg|v ground|sway over ground|transverse ground speed|v over ground|transverse speed over ground|"
            "quergeschwindigkeit ueber grund"},

    NameRow{
        Quantity::shaft_speed, "English",
        "rpm|rps|shaft rpm|shaft speed|propeller rpm|propeller speed|prop rpm|engine rpm|revs|rev|revolutions|"
        "shaft revolutions|propeller revolutions|shaft revs|n prop|n p|np|main engine rpm|me rpm|prop revs|"
        "propeller rate|prop rev|prop rate|prop speed|propeller rev|propeller revs|shaft rate|propeller rps|shaft rps"},
    NameRow{Quantity::shaft_speed, "German",
            "drehzahl|welle|wellendrehzahl|propellerdrehzahl|schraubendrehzahl|maschinendrehzahl|drehzahl welle|"
            "drehzahl propeller|umdrehungen|hauptmaschine drehzahl"},
    NameRow{Quantity::shaft_speed, "Norwegian, Danish",
            "turtall|omdreininger|omdrejninger|akselturtall|propellturtall|omdrejningstal|propelomdrejninger|turtall "
            "aksel"},
    NameRow{Quantity::shaft_speed, "Dutch", "toerental|astoerental|schroeftoerental|omwentelingen"},
    NameRow{Quantity::shaft_speed, "Spanish", "revoluciones|rpm eje|rpm helice|revoluciones eje|revoluciones helice"},
    NameRow{Quantity::shaft_speed, "Japanese", "kaitensu|kaitensuu|jiku kaitensu|puropera kaitensu|shuki kaitensu"},
    NameRow{Quantity::thrust, "all",
            "thrust|propeller thrust|shaft thrust|schub|propellerschub|thrust total|total thrust|skyvekraft|stuwkracht|"
            "empuje|suiryoku"},
    NameRow{Quantity::torque, "all",
            "torque|shaft torque|propeller torque|drehmoment|wellendrehmoment|propellerdrehmoment|moment welle|"
            "dreiemoment|drejningsmoment|koppel|par motor|toruku"},
    NameRow{Quantity::roll, "all",
            "roll|roll angle|heel|heel angle|phi|list|heeling angle|rollwinkel|kraengung|kraengungswinkel|"
            "krenging|krengning|rull|rullvinkel|rulning|rulvinkel|slagside|slinger|slagzij|helling|slingerhoek|"
            "balance|balanceo|escora|angulo balance|yokoyure|yokoyure kaku|keisha|oudou"},
    NameRow{Quantity::wind_speed, "all",
            "tws|true wind speed|wind speed true|true windspeed|wahre windgeschwindigkeit|windgeschwindigkeit wahr|"
            "wahrer wind geschwindigkeit|sann vindstyrke|sann vindhastighet|sand vindhastighed|ware windsnelheid|"
            "velocidad viento real|velocidad viento verdadero|shin fusoku|shinfusoku"},
    NameRow{Quantity::wind_from, "all",
            "twd|true wind direction|wind direction true|true wind dir|wahre windrichtung|windrichtung wahr|"
            "sann vindretning|sand vindretning|ware windrichting|direccion viento real|direccion viento verdadero|"
            "shin fuko|shinfuko|wind from true|true wind from"},
    NameRow{Quantity::wind_speed_unsaid, "all",
            "wind speed|windspeed|wind|windgeschwindigkeit|vindhastighet|vindhastighed|vindstyrke|windsnelheid|"
            "velocidad viento|fusoku"},
    NameRow{Quantity::wind_from_unsaid, "all",
            "wind direction|wind dir|wind angle|windrichtung|vindretning|windrichting|direccion viento|fuko|fukou|wind "
            "from"},
    NameRow{Quantity::relative_wind_speed, "all",
            "aws|rws|relative wind speed|apparent wind speed|wind speed relative|wind speed apparent|rel wind speed|"
            "wind speed rel|scheinbare windgeschwindigkeit|relative windgeschwindigkeit|windgeschwindigkeit relativ|"
            "relativ vindhastighet|relativ vindhastighed|relatieve windsnelheid|velocidad viento aparente|"
            "velocidad viento relativo|sotai fusoku|app wind speed|windgeschwindigkeit scheinbar"},
    NameRow{Quantity::relative_wind_angle, "all",
            "awa|rwa|rwd|awd|relative wind angle|apparent wind angle|relative wind direction|apparent wind direction|"
            "wind angle relative|wind angle apparent|wind direction relative|wind direction apparent|rel wind dir|"
            "rel wind direction|rel wind angle|wind direction rel|wind angle rel|wind dir rel|scheinbare windrichtung|"
            "relative windrichtung|scheinbarer windwinkel|windrichtung relativ|windrichtung scheinbar|"
            "relativ vindretning|relatieve windrichting|direccion viento aparente|direccion viento relativo|"
            "sotai fuko|sotai fukou|twa|true wind angle"},
    NameRow{
        Quantity::depth, "all",
        "depth|water depth|depth water|depth below transducer|depth transducer|echo sounder|echosounder|sounder depth|"
        "tiefe|wassertiefe|lottiefe|echolot|dybde|vanndybde|vanddybde|diepte|waterdiepte|profundidad|suishin"},
};

}  // namespace swayaw::core::detail
