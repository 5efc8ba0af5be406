// `drydock live` as a page uses it: edits give pictures, and what is shown is what `drydock run` writes, bit for bit. A
// little past 500 lines: all cases speak to one kind of server.
#include <gtest/gtest.h>

#include "LiveTestUtils.h"

#include "Picture/PictureFile.h"

#include <cmath>
#include <cstdlib>
#include <memory>

using namespace LiveTest;

namespace
{

class LiveServer : public testing::Test
{
protected:
	LiveServer()
	{
		Files::create_symlink(DRYDOCK_TEST_SOURCE_DIR "/configs/scenes/toon_character.exr", Folder.Path / "toon.exr");
		Folder.Write("a.json", R"(// Toon bloom.
{
  "scene": { "file": "toon.exr" },
  "volumes": [ { "name": "Base", "bUnbound": true, "Settings": { "BloomIntensity": 1.5, "BloomToonIntensity": 0.1 } } ]
}
)");
	}

	/** The bytes of a picture of the program, against what a run of the config has written to the folder. */
	void ExpectSameBits(const FLiveProgram& Program, const std::string& Run) const
	{
		const FAnswer Codes = Program.Get("/api/picture/now?kind=final8");
		ASSERT_EQ(200, Codes.Status);
		const Drydock::FImage Png = Drydock::ReadPicture((Folder.Path / Run / "final.png").string());
		EXPECT_EQ(std::to_string(Png.Width), Codes.Headers.at("x-drydock-width"));
		EXPECT_EQ(std::to_string(Png.Height), Codes.Headers.at("x-drydock-height"));
		ASSERT_EQ(size_t(Png.Width) * size_t(Png.Height) * 4, Codes.Body.size());
		int NumDifferent = 0;
		for (size_t Pixel = 0; Pixel < Codes.Body.size() / 4; ++Pixel)
		{
			for (size_t Channel = 0; Channel < 3; ++Channel)
			{
				const long Code = std::lround(Png.Values[Pixel * 3 + Channel] * 255.0);
				NumDifferent += static_cast<unsigned char>(Codes.Body[Pixel * 4 + Channel]) == Code ? 0 : 1;
			}
			NumDifferent += Codes.Body[Pixel * 4 + 3] == '\xff' ? 0 : 1;
		}
		EXPECT_EQ(0, NumDifferent);

		const FAnswer Floats = Program.Get("/api/picture/now?kind=final");
		Drydock::FImageFile Exr((Folder.Path / Run / "final.exr").string());
		const std::vector<std::vector<float>> Planes =
			Exr.Read({Exr.FindChannel("R"), Exr.FindChannel("G"), Exr.FindChannel("B")});
		ASSERT_EQ(Planes[0].size() * 4 * sizeof(float), Floats.Body.size());
		const float* Texel = reinterpret_cast<const float*>(Floats.Body.data());
		for (size_t Pixel = 0; Pixel < Planes[0].size(); ++Pixel, Texel += 4)
		{
			ASSERT_TRUE(Texel[0] == Planes[0][Pixel] && Texel[1] == Planes[1][Pixel] && Texel[2] == Planes[2][Pixel] &&
						Texel[3] == 1.0f)
				<< Pixel;
		}
	}

	const FProgramFolder Folder{"live"};
};

} // namespace

TEST_F(LiveServer, ShowsWhatRunWritesOfTheSavedConfig)
{
	const FLiveProgram Program(Folder.Path, {"a.json", "--set", "r.BloomQuality=3", "--pp", "BloomIntensity=2"});
	FEventStream Events(Program);
	EXPECT_EQ(200, Events.Status);
	EXPECT_EQ(200, Program.Edit("/camera/Settings/BloomIntensity", 2.75).Status);
	EXPECT_EQ(200, Program.Edit("/volumes/0/Settings/VignetteIntensity", 0.9).Status);
	const FAnswer Edited = Program.Edit("/camera/Settings/BloomToonIntensity", 0.5);
	const FJson Revision = Edited.Json()["revision"];
	FJson Frame = Events.WaitFor("frame");
	while (Frame["revision"] != Revision)
	{
		Frame = Events.WaitFor("frame");
	}
	EXPECT_EQ(960, Frame["width"]);
	EXPECT_EQ(540, Frame["height"]);
	EXPECT_GT(Frame["passes"].size(), 10u);
	EXPECT_EQ(Frame["passesRun"].get<size_t>() + Frame["passesReused"].get<size_t>(), Frame["passes"].size());

	EXPECT_EQ(200, Program.Post("/api/save", {{"path", "saved.json"}}).Status);
	const FJson Saved = FJson::parse(Folder.Read("saved.json"), nullptr, true, true);
	EXPECT_EQ(2.75, Saved["camera"]["Settings"]["BloomIntensity"]);
	EXPECT_EQ(3, Saved["cvars"]["r.BloomQuality"]);
	EXPECT_TRUE(Folder.Read("saved.json").starts_with("// Toon bloom."));
	ASSERT_EQ(0, Folder.Call("run saved.json --out out --report off").ExitCode);
	ExpectSameBits(Program, "out");

	const FJson State = Program.State();
	EXPECT_EQ(Revision, State["revision"]);
	EXPECT_TRUE(State["changed"]);
	for (const FJson& Setting : State["settings"])
	{
		if (Setting["name"] == "BloomIntensity")
		{
			EXPECT_EQ("Intensity", Setting["display"]);
			EXPECT_EQ("Lens|Bloom", Setting["category"]);
			EXPECT_EQ(2.75, Setting["value"]);
			EXPECT_EQ(2, Setting["start"]);
			EXPECT_EQ(0.675, Setting["default"]);
			EXPECT_TRUE(Setting["overridden"]);
			EXPECT_EQ(FJson({"Base"}), Setting["inVolumes"]);
			EXPECT_EQ(0, Setting["range"]["clampMin"]);
			EXPECT_EQ("", Setting["unread"]);
		}
	}

	Folder.Write("session.jsonl", Program.Get("/api/session").Body);
	ASSERT_EQ(0, Folder.Call("live --replay session.jsonl --out again").ExitCode);
	ExpectSameBits(Program, "again");
	EXPECT_EQ(Folder.Read("out/final.exr"), Folder.Read("again/final.exr"));
}

TEST_F(LiveServer, PassesThatAnEditDoesNotReachAreTakenFromTheFrameBefore)
{
	for (const bool bReuse : {true, false})
	{
		std::vector<std::string> Arguments = {"a.json"};
		if (!bReuse)
		{
			Arguments.push_back("--no-reuse");
		}
		const FLiveProgram Program(Folder.Path, Arguments);
		Program.WaitForFrame();
		EXPECT_EQ(200, Program.Edit("/camera/Settings/ColorGamma", {1.0, 1.0, 1.0, 1.25}).Status);
		const FJson State = Program.WaitForFrame();
		ASSERT_TRUE(State["fault"].is_null());
		int NumBloom = 0;
		int NumTonemap = 0;
		for (const FJson& Pass : State["frame"]["passes"])
		{
			const std::string Name = Pass["name"];
			const bool bBloom = Name.find("Bloom") != std::string::npos && !Name.starts_with("CopyTexture");
			const bool bTonemap = Name.find("Tonemap") != std::string::npos;
			NumBloom += bBloom ? 1 : 0;
			NumTonemap += bTonemap ? 1 : 0;
			EXPECT_TRUE(!bBloom || Pass["reused"] == bReuse) << Name;
			EXPECT_TRUE(!bTonemap || !Pass["reused"]) << Name;
		}
		EXPECT_GE(NumBloom, 2);
		EXPECT_EQ(1, NumTonemap);
	}
}

TEST_F(LiveServer, AMistakeIsRefusedAndTheStateStays)
{
	const FLiveProgram Program(Folder.Path, {"a.json"});
	const FJson Before = Program.WaitForFrame();
	const FAnswer Number = Program.Edit("/camera/Settings/BloomIntensity", "much");
	EXPECT_EQ(422, Number.Status);
	EXPECT_EQ("DD1006", Number.Code());
	EXPECT_EQ("/camera/Settings/BloomIntensity", Number.Json()["messages"][0]["where"]);
	const FAnswer Name = Program.Edit("/camera/Settings/BloomIntensty", 1);
	EXPECT_EQ(422, Name.Status);
	EXPECT_EQ("DD1012", Name.Code());
	EXPECT_EQ("DD1120", Program.Post("/api/edit", {{"edits", {{{"remove", "/camera"}}}}}).Code());
	EXPECT_EQ("DD1120", Program.Post("/api/edit", FJson::object()).Code());
	EXPECT_EQ(422, Program.Change("undo").Status);
	EXPECT_EQ(Before["revision"], Program.State()["revision"]);
	EXPECT_FALSE(Program.State()["changed"]);
}

TEST_F(LiveServer, UndoRedoResetAndPinsAreTheServers)
{
	const FLiveProgram Program(Folder.Path, {"a.json"});
	const auto GetBloom = [&]
	{
		const FJson State = Program.WaitForFrame();
		for (const FJson& Setting : State["settings"])
		{
			if (Setting["name"] == "BloomIntensity")
			{
				return Setting["value"].get<double>();
			}
		}
		return -1.0;
	};
	EXPECT_EQ(1.5, GetBloom());
	const std::string Start = Program.Get("/api/picture/now?kind=final8").Body;
	Program.Edit("/camera/Settings/BloomIntensity", 3);
	Program.Edit("/camera/Settings/BloomIntensity", 4, "d");
	Program.Edit("/camera/Settings/BloomIntensity", 5, "d");
	EXPECT_EQ(5.0, GetBloom());
	const FJson Pin = Program.Post("/api/pin", {{"name", "bright"}}).Json()["pin"];
	EXPECT_EQ(FJson({{{"pin", Pin}, {"name", "bright"}, {"revision", Program.State()["revision"]}}}),
		Program.State()["pins"]);
	const std::string Bright = Program.Get("/api/picture/now?kind=final8").Body;
	EXPECT_NE(Start, Bright);
	EXPECT_EQ(200, Program.Change("undo").Status);
	EXPECT_EQ(3.0, GetBloom());
	EXPECT_EQ(200, Program.Change("redo").Status);
	EXPECT_EQ(5.0, GetBloom());
	EXPECT_EQ(200, Program.Change("reset", "/camera/Settings/BloomIntensity").Status);
	EXPECT_EQ(1.5, GetBloom());
	EXPECT_EQ(200, Program.Change("undo").Status);
	EXPECT_EQ(200, Program.Change("reset").Status);
	EXPECT_EQ(1.5, GetBloom());
	EXPECT_FALSE(Program.State()["changed"]);
	EXPECT_EQ(Start, Program.Get("/api/picture/now?kind=final8").Body);
	EXPECT_EQ(Start, Program.Get("/api/picture/start?kind=final8").Body);
	EXPECT_EQ(Bright, Program.Get("/api/picture/pin-" + Pin.dump() + "?kind=final8").Body);
	EXPECT_EQ(200, Program.Post("/api/unpin", {{"pin", Pin}}).Status);
	EXPECT_EQ(404, Program.Get("/api/picture/pin-" + Pin.dump() + "?kind=final8").Status);
	EXPECT_EQ(422, Program.Post("/api/unpin", {{"pin", "x"}}).Status);
}

TEST_F(LiveServer, SavesBesideTheConfigOrUnderOutAndNowhereElse)
{
	Files::create_directories(Folder.Path / "elsewhere");
	Files::create_symlink(Folder.Path / "elsewhere", Folder.Path / "link");
	const FLiveProgram Program(Folder.Path, {"a.json", "--out", "out"});
	Program.Edit("/camera/Settings/BloomIntensity", 3);
	const auto Save = [&](const std::string& Path, bool bAgain = false)
	{
		return Program.Post("/api/save", {{"path", Path}, {"again", bAgain}}).Status;
	};
	for (const char* const Bad : {"", "x", "x.txt", "../x.json", "elsewhere/x.json", "link/x.json",
			 "out/../elsewhere/x.json", "/etc/x.json", "/tmp/x.json", "out/x.json/../../../x.json"})
	{
		EXPECT_EQ(422, Save(Bad)) << Bad;
	}
	EXPECT_EQ(422, Save(std::string("x\0.json", 7)));
	EXPECT_EQ(409, Save("a.json"));
	EXPECT_EQ(200, Save("b.json"));
	EXPECT_EQ(409, Save("b.json"));
	EXPECT_EQ(200, Save("b.json", true));
	EXPECT_EQ(200, Save("out/deep/c.json"));
	EXPECT_TRUE(Files::is_empty(Folder.Path / "elsewhere"));
	EXPECT_EQ("../../toon.exr", FJson::parse(Folder.Read("out/deep/c.json"), nullptr, true, true)["scene"]["file"]);
	EXPECT_EQ(0, Folder.Call("check out/deep/c.json").ExitCode);
	EXPECT_EQ(Folder.Read("b.json"), Program.Get("/api/text?as=config").Body);
	EXPECT_EQ("{\"set\": \"/camera/Settings/BloomIntensity\", \"value\": 3}\n", Program.Get("/api/text?as=lines").Body);
	EXPECT_NE(std::string::npos, Program.Get("/api/text?as=engine").Body.find("bOverride_BloomIntensity=True"));
}

TEST_F(LiveServer, EndsByItsButtonAndBySignals)
{
	FLiveProgram ByButton(Folder.Path, {"a.json"});
	FEventStream Events(ByButton);
	EXPECT_EQ(200, ByButton.Post("/api/end").Status);
	EXPECT_EQ(FJson::object(), Events.WaitFor("bye"));
	EXPECT_EQ(0, ByButton.WaitForEnd());
	for (const int Signal : {SIGINT, SIGTERM})
	{
		FLiveProgram Program(Folder.Path, {"a.json"});
		FEventStream Told(Program);
		Program.Signal(Signal);
		EXPECT_EQ(FJson::object(), Told.WaitFor("bye"));
		EXPECT_EQ(128 + Signal, Program.WaitForEnd());
	}
}

TEST_F(LiveServer, OpensTheBrowserByAFileThatTheUserAloneReads)
{
	Folder.Write("xdg-open", "#!/bin/sh\nstat -c %a \"$1\" > mode\ncp \"$1\" opened.part\nmv opened.part opened\n");
	Files::permissions(Folder.Path / "xdg-open", Files::perms::owner_all);
	const std::string Path = std::getenv("PATH");
	setenv("PATH", (Folder.Path.string() + ":" + Path).c_str(), 1);
	setenv("DISPLAY", ":77", 1);
	const FLiveProgram Program(Folder.Path, {"a.json"}, true);
	setenv("PATH", Path.c_str(), 1);
	unsetenv("DISPLAY");
	for (int Try = 0; Try < 600 && !Files::exists(Folder.Path / "opened"); ++Try)
	{
		std::this_thread::sleep_for(std::chrono::milliseconds(100));
	}
	const std::string Address = "http://127.0.0.1:" + std::to_string(Program.Port) + "/?token=" + Program.Token;
	EXPECT_NE(std::string::npos, Folder.Read("opened").find("url=" + Address + "\"")) << Folder.Read("opened");
	EXPECT_EQ("600\n", Folder.Read("mode"));
}

TEST_F(LiveServer, TellsWhatIsWrongBeforeItStarts)
{
	Folder.Write(
		"bad.json", R"({"scene": {"file": "toon.exr"}, "volumes": [{"bUnbound": true, "Settings": {"Blum": 1}}]})");
	EXPECT_EQ(2, Folder.Call("live bad.json --no-open").ExitCode);
	EXPECT_EQ(3, Folder.Call("live missing.json --no-open").ExitCode);
	EXPECT_EQ(2, Folder.Call("live --no-open").ExitCode);
	EXPECT_EQ(2, Folder.Call("live a.json --set nonsense --no-open").ExitCode);
	EXPECT_EQ(2, Folder.Call("live --replay a.json").ExitCode);
	const FLiveProgram Program(Folder.Path, {"a.json"});
	const FOutcome Taken = Folder.Call("live a.json --no-open --port " + std::to_string(Program.Port));
	EXPECT_EQ(3, Taken.ExitCode);
	EXPECT_NE(std::string::npos, Taken.Printed.find("DD5040")) << Taken.Printed;
}

TEST_F(LiveServer, FollowsFilesThatOthersEdit)
{
	const FLiveProgram Program(Folder.Path, {"a.json"});
	Program.WaitForFrame();
	FEventStream Events(Program);
	const std::string Text = Folder.Read("a.json");
	const auto Write = [&](const std::string& From, const std::string& To)
	{
		std::string Edited = Text;
		Edited.replace(Edited.find(From), From.size(), To);
		Folder.Write("a.json", Edited);
	};
	Write("1.5", "4.5");
	EXPECT_TRUE(Events.WaitFor("frame").is_object());
	EXPECT_TRUE(Program.State()["canUndo"]);
	const std::string Good = Program.Get("/api/picture/now?kind=final8").Body;
	Write("\"BloomIntensity\": 1.5", "\"BloomIntensity\": \"x\"");
	const FJson Fault = Events.WaitFor("fault");
	EXPECT_EQ("DD1006", Fault["messages"][0]["code"]);
	EXPECT_EQ(4, Fault["messages"][0]["line"]);
	EXPECT_TRUE(Fault["messages"][0]["file"].get<std::string>().ends_with("a.json"));
	EXPECT_EQ(Good, Program.Get("/api/picture/now?kind=final8").Body);
	Write("1.5", "1.25");
	EXPECT_TRUE(Events.WaitFor("frame").is_object());
	EXPECT_TRUE(Program.State()["fault"].is_null());
}

TEST_F(LiveServer, FollowsShadersAndNamesTheLineOfAMistake)
{
	ASSERT_EQ(0, Folder.Call("overlay new MyCurve --pass Tonemap").ExitCode);
	const std::string File = "MyCurve/Engine/Shaders/Private/PostProcessTonemap.usf";
	const std::string Text = Folder.Read(File);
	const FLiveProgram Program(Folder.Path, {"MyCurve/MyCurve.json"});
	Program.WaitForFrame();
	const std::string Good = Program.Get("/api/picture/now?kind=final8").Body;
	FEventStream Events(Program);
	const size_t At = Text.find("OutColor = ");
	ASSERT_NE(std::string::npos, At);
	const long Line = std::count(Text.begin(), Text.begin() + static_cast<long>(At), '\n') + 1;
	const auto Write = [&](const std::string& Inserted)
	{
		Folder.Write(File, std::string(Text).insert(At, Inserted));
	};
	Write("OutColor = 1; return; ");
	EXPECT_TRUE(Events.WaitFor("frame").is_object());
	const std::string White = Program.Get("/api/picture/now?kind=final8").Body;
	EXPECT_EQ(std::string(White.size(), '\xff'), White);
	Write("nonsense; ");
	const FJson Fault = Events.WaitFor("fault");
	EXPECT_EQ(Line, Fault["messages"][0]["line"]) << Fault;
	EXPECT_TRUE(Fault["messages"][0]["file"].get<std::string>().ends_with("PostProcessTonemap.usf")) << Fault;
	EXPECT_EQ(White, Program.Get("/api/picture/now?kind=final8").Body);
	EXPECT_FALSE(Program.State()["fault"].is_null());
	Write("");
	EXPECT_TRUE(Events.WaitFor("frame").is_object());
	EXPECT_EQ(Good, Program.Get("/api/picture/now?kind=final8").Body);
	EXPECT_TRUE(Program.State()["fault"].is_null());
	EXPECT_FALSE(Program.State()["changed"]); // the config is as it was
}

TEST_F(LiveServer, AnswersWhatTheVerbsPrint)
{
	const FLiveProgram Program(Folder.Path, {"a.json"});
	Program.WaitForFrame();
	const auto Print = [&](const std::string& Arguments)
	{
		return Folder.Call(Arguments + " 2>/dev/null; true").Printed;
	};
	EXPECT_EQ(FJson::parse(Print("probe a.json 300,200 --json")), Program.Get("/api/probe?x=300&y=200").Json()["json"]);
	EXPECT_EQ(Print("trace a.json --pass Tonemap --pixel 300,200"),
		Program.Get("/api/trace?x=300&y=200&pass=Tonemap").Json()["text"]);
	EXPECT_EQ(422, Program.Get("/api/probe?x=30000&y=200").Status);
	EXPECT_EQ(422, Program.Get("/api/probe?x=a&y=200").Status);
	const FJson Blend = FJson::parse(Print("blend a.json --setting BloomIntensity --json"));
	EXPECT_EQ(Blend["ledger"]["BloomIntensity"],
		Program.Get("/api/ledger?setting=BloomIntensity").Json()["ledger"]["BloomIntensity"]);
	EXPECT_EQ(422, Program.Get("/api/ledger?setting=Blum").Status);
	const FJson Report = Program.Get("/api/report/now").Json();
	EXPECT_EQ("run", Report["kind"]);
	EXPECT_GT(Report["graph"]["passes"].size(), 10u);
	// The texture after a pass, as a dump has it.
	const FJson State = Program.State();
	for (const FJson& Pass : State["frame"]["passes"])
	{
		if (Pass["name"].get<std::string>().starts_with("BloomSetup"))
		{
			const FAnswer Picture =
				Program.Get("/api/picture/now?kind=pass&pass=" + Pass["index"].dump() + "&resource=BloomSetup");
			EXPECT_EQ(200, Picture.Status);
			EXPECT_EQ("480", Picture.Headers.at("x-drydock-width"));
			EXPECT_EQ(size_t(480 * 270 * 16), Picture.Body.size());
		}
	}
	EXPECT_EQ(422, Program.Get("/api/picture/now?kind=pass&pass=1&resource=Nothing").Status);
}

TEST_F(LiveServer, AnEditOfAVolumeOfTheSceneWritesAllOfThemIntoTheConfig)
{
	const FLiveProgram Program(Folder.Path, {DRYDOCK_TEST_SOURCE_DIR "/configs/sequence.json"});
	const FJson Before = Program.WaitForFrame();
	ASSERT_EQ(2u, Before["volumes"].size());
	EXPECT_EQ(200, Program.Edit("/volumes/1/Priority", 7).Status);
	const FJson After = Program.WaitForFrame();
	EXPECT_EQ(7, After["volumes"][1]["priority"]);
	for (const char* const Kept : {"name", "bounds", "blendRadius", "unbound", "enabled"})
	{
		for (size_t Volume = 0; Volume < 2; ++Volume)
		{
			EXPECT_EQ(Before["volumes"][Volume][Kept], After["volumes"][Volume][Kept]) << Kept;
		}
	}
	for (size_t Setting = 0; Setting < Before["settings"].size(); ++Setting)
	{
		EXPECT_EQ(Before["settings"][Setting]["inVolumes"], After["settings"][Setting]["inVolumes"]);
	}
	EXPECT_EQ(200, Program.Change("undo").Status);
	EXPECT_EQ(Before["volumes"], Program.State()["volumes"]);
	EXPECT_NE(std::string::npos, Program.Get("/api/text?as=config").Body.find("\"fromScene\""));
}

TEST_F(LiveServer, ShowsEachFrameOfASequenceAsRunWritesIt)
{
	const FLiveProgram Program(Folder.Path, {DRYDOCK_TEST_SOURCE_DIR "/configs/sequence.json", "--out", "."});
	EXPECT_EQ(FJson({{"frame", 1}, {"frames", {1, 2, 3, 4, 5, 6, 7, 8}}}), Program.WaitForFrame()["sequence"]);
	const std::string First = Program.Get("/api/picture/now?kind=final8").Body;
	EXPECT_EQ(200, Program.Edit("/scene/frames", "4").Status);
	EXPECT_EQ(4, Program.WaitForFrame()["sequence"]["frame"]);
	EXPECT_NE(First, Program.Get("/api/picture/now?kind=final8").Body);
	EXPECT_EQ(200, Program.Post("/api/save", {{"path", (Folder.Path / "fourth.json").string()}}).Status);
	ASSERT_EQ(0, Folder.Call("run fourth.json --frame 4 --out out --report off").ExitCode);
	ExpectSameBits(Program, "out");
	EXPECT_EQ(422, Program.Edit("/scene/frames", "x").Status);
}

TEST_F(LiveServer, ASmallerPictureHoldsTheMeansOfTheWhole)
{
	const FLiveProgram Program(Folder.Path, {"a.json"});
	for (const double Intensity : {2.0, 3.0}) // made when it is asked for, then with its frame
	{
		Program.Edit("/camera/Settings/BloomIntensity", Intensity);
		Program.WaitForFrame();
		const FAnswer Answer = Program.Get("/api/picture/now?kind=final8&step=7");
		EXPECT_EQ(size_t(60 * 34 * 4), Program.Get("/api/picture/now?kind=final8&step=7000").Body.size()); // 16 at most
		const std::string Codes = Program.Get("/api/picture/now?kind=final8").Body;
		Program.Get("/api/picture/now?kind=final8&step=7"); // the last that is asked for is made with the next frame
		EXPECT_EQ("960", Answer.Headers.at("x-drydock-width"));
		constexpr size_t Width = 960, Height = 540, Step = 7, SmallWidth = 138, SmallHeight = 78; // 960 = 137 * 7 + 1
		ASSERT_EQ(SmallWidth * SmallHeight * 4, Answer.Body.size());
		for (size_t Index = 0; Index < Answer.Body.size(); ++Index)
		{
			const size_t Left = Index / 4 % SmallWidth * Step, Top = Index / 4 / SmallWidth * Step;
			const size_t Right = std::min(Left + Step, Width), Bottom = std::min(Top + Step, Height);
			double Sum = 0.0;
			for (size_t Y = Top; Y < Bottom; ++Y)
			{
				for (size_t X = Left; X < Right; ++X)
				{
					Sum += static_cast<unsigned char>(Codes[(Y * Width + X) * 4 + Index % 4]);
				}
			}
			const double Mean = Sum / static_cast<double>((Right - Left) * (Bottom - Top));
			ASSERT_LE(std::abs(Mean - static_cast<unsigned char>(Answer.Body[Index])), 0.5) << Index;
		}
	}
}

TEST_F(LiveServer, NamesThePicturesBesideTheConfig)
{
	Files::create_directories(Folder.Path / "textures/deep");
	for (const char* const Name : {"textures/dirt.png", "textures/deep/far.png", "textures/notes.txt"})
	{
		Folder.Write(Name, "");
	}
	const FLiveProgram Program(Folder.Path, {"a.json"});
	EXPECT_EQ(FJson({{"pictures", {"textures/dirt.png", "toon.exr"}}}), Program.Get("/api/pictures").Json());
}

TEST_F(LiveServer, TheMeasurementOfAPriceGivesWayToAnEdit)
{
	const FLiveProgram Program(Folder.Path, {"a.json"});
	Program.WaitForFrame();
	FConnection Price(Program.Port);
	Price.Send(FLiveProgram::MakeRequest("POST", "/api/price", Program.MakeHeaders()));
	std::this_thread::sleep_for(std::chrono::milliseconds(10)); // it has begun, and takes six frames and one in double
	EXPECT_EQ(200, Program.Edit("/camera/Settings/BloomIntensity", 3).Status);
	const FAnswer Answer = Price.ReadAnswer();
	EXPECT_EQ(422, Answer.Status);
	EXPECT_EQ("DD1120", Answer.Code());
	EXPECT_TRUE(Program.WaitForFrame()["dots"].empty());
	EXPECT_EQ(200, Program.Post("/api/price").Status);
	EXPECT_EQ(1u, Program.State()["dots"].size());
}

TEST_F(LiveServer, NewestWinsUnderAFlood)
{
	const FLiveProgram Program(Folder.Path, {"a.json"});
	Program.WaitForFrame();
	FEventStream Events(Program);
	std::vector<std::unique_ptr<FConnection>> Hands;
	for (int Hand = 0; Hand < 4; ++Hand)
	{
		Hands.push_back(std::make_unique<FConnection>(Program.Port));
	}
	constexpr int NumEdits = 300;
	for (int Edit = 0; Edit < NumEdits;)
	{
		for (const std::unique_ptr<FConnection>& Hand : Hands)
		{
			const FJson Body = {
				{"edits", {{{"set", "/camera/Settings/BloomIntensity"}, {"value", 1 + ++Edit * 0.01}}}}, {"drag", "d"}};
			ASSERT_TRUE(Hand->Send(FLiveProgram::MakeRequest("POST", "/api/edit", Program.MakeHeaders(), Body.dump())));
		}
		for (const std::unique_ptr<FConnection>& Hand : Hands)
		{
			ASSERT_EQ(200, Hand->ReadAnswer().Status);
		}
	}
	const FJson State = Program.WaitForFrame();
	EXPECT_EQ(State["revision"], State["frame"]["revision"]);
	EXPECT_LE(Program.Get("/api/session").Body.size(), 2000u);
	int NumFrames = 0;
	for (FJson Frame; (Frame = Events.WaitFor("frame")).is_object();)
	{
		++NumFrames;
		if (Frame["revision"] == State["revision"])
		{
			break;
		}
	}
	EXPECT_LT(NumFrames, NumEdits);
	EXPECT_EQ(200, Program.Change("undo").Status);
	EXPECT_FALSE(Program.State()["canUndo"]);
}
