// Shows the clouds of a camera.
#include <pcl/io/openni_grabber.h>
#include <pcl/visualization/cloud_viewer.h>

#include <chrono>
#include <functional>
#include <iostream>
#include <thread>

int
main()
{
  int clouds = 0;
  pcl::visualization::CloudViewer viewer("clouds");
  const std::function<void(const pcl::PointCloud<pcl::PointXYZRGBA>::ConstPtr&)> show =
      [&](const pcl::PointCloud<pcl::PointXYZRGBA>::ConstPtr& cloud) {
        viewer.showCloud(cloud);
        ++clouds;
      };

  pcl::OpenNIGrabber grabber;
  grabber.registerCallback(show);
  grabber.start();
  while (grabber.isRunning() && !viewer.wasStopped())
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  grabber.stop();
  std::cout << clouds << " clouds\n";
}
