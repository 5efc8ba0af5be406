// A shared object that registers nothing.
extern "C" int EmptyPluginAnswer()
{
	return 42;
}
